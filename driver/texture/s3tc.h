// S3TC blocks of 4x4 texels (EXT_texture_compression_s3tc), for images that the driver itself must
// compress or take apart. Applications' own blocks go to the device as they are.

#pragma once

#include "model/device/formats.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::gl {

using Rgba8Texel = std::array<std::uint8_t, 4>;
using TexelBlock = std::array<Rgba8Texel, 16>; // row by row

// As the device's sampler reads a block: colours are expanded to 8 bits by repeating their high
// bits, palette entries between are (2a + b) / 3 or (a + b) / 2, rounded down.
TexelBlock decode_block(Format format, const std::byte* block);

// The ends of the palette are the corners of the colours' bounding box.
void encode_block(Format format, const TexelBlock& texels, std::byte* block);

// An image of r g b a bytes, rows without padding, to and from blocks. Texels beyond the edge
// repeat the last ones.
std::vector<std::byte>
compress(Format format, const std::byte* rgba, std::uint32_t width, std::uint32_t height);
std::vector<std::byte>
decompress(Format format, const std::byte* blocks, std::uint32_t width, std::uint32_t height);

} // namespace ffgpu::gl
