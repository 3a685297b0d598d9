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

// Of each texel of a probe: what the filter says of single texels; else what it makes of levels and
// axes; the words of a table, which are no texels, count alike.
std::vector<std::vector<double>> shares_in_probe(const ProbeNote& probe) {
    std::vector<std::vector<double>> shares;
    double sum = 0;
    for (std::size_t i = 0; i < probe.levels.size(); ++i) {
        const probed::LevelFilter& filter = probe.levels[i];
        const double next = probe.probe.next_level / 256.0;
        std::vector<double>& of_filter = shares.emplace_back();
        for (unsigned t = 0; t < filter.texel_count; ++t) {
            of_filter.push_back(filter.texel_weights ? (*filter.texel_weights)[t]
                                : filter.along_x_count > 0
                                    ? (i == 0 ? 1 - next : next) * share_in_filter(filter, t)
                                    : 1);
            sum += of_filter.back();
        }
    }
    for (std::vector<double>& of_filter : shares)
        for (double& share : of_filter)
            share /= sum;
    return shares;
}

} // namespace

std::map<TexelName, double> texel_shares(const TextureNote& texture) {
    std::map<TexelName, double> shares;
    double weights = 0;
    for (const ProbeNote& probe : texture.probes)
        weights += probe.probe.weight;
    for (const ProbeNote& probe : texture.probes) {
        const auto in_probe = shares_in_probe(probe);
        for (std::size_t i = 0; i < probe.levels.size(); ++i) {
            const probed::LevelFilter& filter = probe.levels[i];
            for (unsigned t = 0; t < filter.texel_count; ++t) {
                const probed::Texel& texel = filter.texels[t];
                if (texel.bytes == 0) continue;
                shares[{filter.access.level, texel.layer, texel.y, texel.x}] +=
                    probe.probe.weight / weights * in_probe[i][t];
            }
        }
    }
    return shares;
}

} // namespace ffgpu::tools
