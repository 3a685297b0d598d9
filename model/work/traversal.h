// The order in which a rasterizer walks the quads of one piece of a primitive.

#pragma once

#include "model/work/config.h"

#include <cstdint>

namespace ffgpu::work {

constexpr std::uint64_t
traversal_tile(const RasterOrder& raster, std::uint32_t x, std::uint32_t y) {
    if (raster.traversal != Traversal::Tiled) return 0;
    return std::uint64_t{y / raster.tile_width} << 12 | (x / raster.tile_width);
}

// 48 bits: tile, then row and column (or the other way round) of the quad.
constexpr std::uint64_t traversal_key(const RasterOrder& raster, std::uint32_t x, std::uint32_t y) {
    const std::uint64_t row = y / 2, column = x / 2;
    const std::uint64_t place =
        raster.traversal == Traversal::Column ? column << 12 | row : row << 12 | column;
    return traversal_tile(raster, x, y) << 24 | place;
}

// The same for a fragment: it takes the place of a quad, on a picture of twice the size.
constexpr std::uint64_t
fragment_traversal_key(RasterOrder raster, std::uint32_t x, std::uint32_t y) {
    raster.tile_width *= 2;
    return traversal_key(raster, 2 * x, 2 * y);
}

constexpr std::uint32_t screen_bin(const RasterOrder& raster, std::uint32_t x, std::uint32_t y) {
    return (y / raster.bin_size) << 12 | (x / raster.bin_size);
}

} // namespace ffgpu::work
