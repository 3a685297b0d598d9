#include "tools/explain/footprint.h"

namespace ffgpu::tools {
namespace {

// Of texel i of a filter, whose bits say which of two texels it is along each axis it has.
double share_in_filter(const probed::LevelFilter& filter, unsigned i) {
    double share = 1;
    for (unsigned axis = 0; axis < 3; ++axis) {
        if (!(filter.access.linear >> axis & 1)) continue;
        const double second = filter.weight[axis] / 256.0;
        share *= i & 1 ? second : 1 - second;
        i >>= 1;
    }
    return share;
}

} // namespace

std::map<TexelName, double> texel_shares(const TextureNote& texture) {
    std::map<TexelName, double> shares;
    for (const ProbeNote& probe : texture.probes) {
        const double next = texture.quad->weight / 256.0;
        for (std::size_t i = 0; i < probe.levels.size(); ++i) {
            const probed::LevelFilter& filter = probe.levels[i];
            const double of_level =
                (i == 0 ? 1 - next : next) / static_cast<double>(texture.probes.size());
            for (unsigned t = 0; t < filter.texel_count; ++t) {
                const probed::Texel& texel = filter.texels[t];
                if (texel.bytes == 0) continue;
                shares[{filter.access.level, texel.layer, texel.y, texel.x}] +=
                    of_level * share_in_filter(filter, t);
            }
        }
    }
    return shares;
}

} // namespace ffgpu::tools
