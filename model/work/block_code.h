// Lossless codes of blocks of depths and colours (docs/units/depth_hierarchy.md). A block is what a
// line of a cache holds: pixels in rows, a pixel's samples together. Each sample's pixels are coded
// on their own; samples that equal the first one take a bit.
//
// Depths: all equal; or a plane through three corners and what the pixels differ from it; or two
// planes, each through pixels at a corner, and a choice a pixel; or as they are. After J.
// Hasselgren and T. Akenine-Moeller, Efficient Depth Buffer Compression, 2006 (plane encoding and
// differential prediction there).
// Colours: a channel's pixels as steps from their least value, or from their neighbour's.

#pragma once

#include "model/device/layout/formats.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

struct BlockShape {
    Format format = Format::Rgba8;
    std::uint32_t width = 4, height = 4; // pixels
    std::uint32_t samples = 1;

    std::uint32_t pixels() const { return width * height; }
    std::uint32_t sample_bytes() const { return format_info(format).block_bytes; }
    std::uint32_t bytes() const { return pixels() * samples * sample_bytes(); }
};

// `block` is shape.bytes() long. What is not smaller than that is of no use.
std::vector<std::uint8_t> encode_block(const BlockShape& shape, std::span<const std::byte> block);
void decode_block(const BlockShape& shape,
                  std::span<const std::uint8_t> code,
                  std::span<std::byte> block);

} // namespace ffgpu::work
