// TexelFootprints: which texels one texture unit read for one batch.

#pragma once

#include "model/packets/texel_accesses.h"

#include <cstdint>

namespace ffgpu {

// Only live fragments are recorded, in lane order; of a fragment the finer level first; of
// anisotropic probes one after the other. A quad may have more than one access a fragment
// (trilinear: 2, anisotropic: up to 32).
struct TexelFootprints {
    std::uint8_t unit = 0;
    TexelAccesses accesses; // of each quad of the batch
};

} // namespace ffgpu
