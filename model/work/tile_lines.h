// The lines of memory that a bin of a surface takes.

#pragma once

#include "model/work/tile_contents.h"
#include "model/work/tile_plan.h"

#include <cstdint>
#include <vector>

namespace ffgpu::work {

constexpr Rectangle bin_rectangle(std::uint32_t bin_size, std::uint32_t bin) {
    const auto size = static_cast<int>(bin_size);
    const int x = static_cast<int>(bin & 0xfff) * size, y = static_cast<int>(bin >> 12) * size;
    return {x, y, x + size, y + size};
}

// Appends the lines that hold the bytes (bit i for byte i of a sample) of the bin's pixels.
void add_bin_lines(const TileTarget& target,
                   const Rectangle& bin,
                   std::uint32_t bytes,
                   std::vector<PlacedLine>& lines);

} // namespace ffgpu::work
