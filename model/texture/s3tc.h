// S3TC blocks: 4x4 texels from two colours or alphas and an index a texel.
//
// Integer arithmetic, divisions rounded down: the end points are widened to 8 bits by replication,
// then interpolated: (2 a + b) / 3, (a + b) / 2, ((7 - i) a + i b) / 7, ((5 - i) a + i b) / 5.

#pragma once

#include "model/device/layout/formats.h"
#include "model/texture/filter.h"

#include <cstddef>

namespace ffgpu {

// Texel (x, y), each 0 .. 3, of the block at `block`; row 0 is the block's first row of indices.
Rgba decode_s3tc(Format format, const std::byte* block, unsigned x, unsigned y);

} // namespace ffgpu
