// Where the parts of a rip-map and the words of a summed-area table lie in the image that a sampler
// reads them from: the one statement that driver and texture unit share. What they are for:
// model/texture/wide_filters.h.
//
// Rip-map: image (i, j) is 2^-i as wide and 2^-j as high as the source, each side rounded down and
// at least one texel; its first texel is at column rip_offset(width, i), row rip_offset(height, j).
//
// Summed-area table: word (x, y) of channel c, a texel of r g b a bytes with the lowest first, is
// at column TableChannels x + c, row y: the sum of the channel over the source's texels from (0, 0)
// through (x, y).

#pragma once

#include "model/device/layout/texture_layout.h"

#include <cstdint>

namespace ffgpu {

constexpr std::uint32_t rip_levels(std::uint32_t size) {
    std::uint32_t levels = 1;
    for (; size > 1; size /= 2)
        ++levels;
    return levels;
}

// Of `level` = rip_levels(size) the size of the whole.
constexpr std::uint32_t rip_offset(std::uint32_t size, std::uint32_t level) {
    std::uint32_t offset = 0;
    for (std::uint32_t i = 0; i < level; ++i)
        offset += level_size(size, i);
    return offset;
}

constexpr std::uint32_t TableChannels = 4;

} // namespace ffgpu
