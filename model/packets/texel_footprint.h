// TexelFootprints: which texels one texture unit read for one batch, as logical coordinates
// (level, layer, x, y): addresses are the timing model's business.

#pragma once

#include "model/packets/fragment_batch.h"

#include <cstdint>
#include <vector>

namespace ffgpu {

// One access of one fragment to one level: 1 texel (nearest), 2x1 (1-D linear), 2x2 (linear), and
// twice that across two layers for 3-D linear. The texels are (x0|x1, y0|y1, layer0|layer1) after
// wrapping, counted in the stored image: from its border if it has one. Texels beyond the edge that
// the border colour stands for are marked by BorderTexel.
struct TexelAccess {
    static constexpr std::uint16_t BorderTexel = 0xffff;

    std::uint16_t lane;  // of the batch
    std::uint8_t level;  // of the image; 0 is its base level
    std::uint8_t linear; // bit 0: x0 and x1 both, bit 1: y0 and y1 both, bit 2: both layers
    std::uint16_t x0, x1, y0, y1;
    std::uint16_t layer0, layer1; // slice or face

    bool operator==(const TexelAccess&) const = default;
};

// Only live fragments are recorded, in lane order; of a fragment the finer level first; of
// anisotropic probes one after the other. `count` may exceed one access a fragment (trilinear: 2,
// anisotropic: up to 32).
struct TexelFootprints {
    std::uint8_t unit = 0;
    std::vector<TexelAccess> accesses;
};

} // namespace ffgpu
