// FXT1 blocks of 8x4 texels (3DFX_texture_compression_FXT1): the compressor. Decoding is the
// device's, model/arith/fxt1.h.

#pragma once

#include "driver/texel/s3tc.h"

namespace ffgpu::gl {

using Fxt1Texels = std::array<Rgba8Texel, 32>; // row by row

// Opaque texels are coded as CC_MIXED, each tile between the two of its texels that differ most:
// exact, but for the precision of the ends, where a tile has no more than two colours. Others are
// coded as CC_ALPHA, exact in the same sense with three colours in the block besides clear.
// `alpha` off: all texels count as opaque.
void encode_fxt1(const Fxt1Texels& texels, bool alpha, std::byte* block);

} // namespace ffgpu::gl
