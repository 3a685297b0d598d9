#include "model/raster/quad_pack.h"

namespace ffgpu {

PackedQuads pack_quads_scalar(const BlockCoverage& block, std::uint16_t* x, std::uint16_t* y) {
    PackedQuads packed;
    for (unsigned quad = 0; quad < BlockQuads; ++quad) {
        const BlockMask lanes = block.mask >> (4 * quad) & 0xf;
        if (lanes == 0) continue;
        x[packed.count] = static_cast<std::uint16_t>(block.x + quad % BlockQuadsAcross * 2);
        y[packed.count] = static_cast<std::uint16_t>(block.y + quad / BlockQuadsAcross * 2);
        packed.lanes |= lanes << (4 * packed.count++);
    }
    return packed;
}

} // namespace ffgpu
