// S3TC blocks of 4x4 texels (EXT_texture_compression_s3tc).

#pragma once

#include "model/device/layout/formats.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace ffgpu::gl {

using Rgba8Texel = std::array<std::uint8_t, 4>;
using TexelBlock = std::array<Rgba8Texel, 16>; // row by row

// As the device's sampler reads a block: colours are expanded to 8 bits by repeating their high
// bits, palette entries between are (2a + b) / 3 or (a + b) / 2, rounded down.
TexelBlock decode_block(Format format, const std::byte* block);

// The ends of the palette are the corners of the colours' bounding box.
void encode_block(Format format, const TexelBlock& texels, std::byte* block);

} // namespace ffgpu::gl
