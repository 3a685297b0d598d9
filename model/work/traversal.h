// The order in which a rasterizer walks the quads of one piece of a primitive. Every order is a
// permutation of the window's quads, whatever the piece; block_walk.h tells which blocks of it are
// walked.

#pragma once

#include "model/work/config.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace ffgpu::work {

constexpr unsigned QuadBits = 12; // of a quad's row and column

// Row by row of squares of 2^size, inside each row by row; coordinates of `bits`.
constexpr std::uint32_t
squares_key(std::uint32_t row, std::uint32_t column, unsigned size, unsigned bits = QuadBits) {
    const std::uint32_t inside = (1u << size) - 1;
    const std::uint32_t square = (row >> size) << (bits - size) | column >> size;
    return square << 2 * size | (row & inside) << size | (column & inside);
}

// The bits of both in turn, the column's lowest first (G. M. Morton, A Computer Oriented Geodetic
// Data Base, 1966).
constexpr std::uint32_t morton_key(std::uint32_t row, std::uint32_t column) {
    std::uint32_t key = 0;
    for (unsigned bit = 0; bit < QuadBits; ++bit)
        key |= (column >> bit & 1) << 2 * bit | (row >> bit & 1) << (2 * bit + 1);
    return key;
}

// The distance along Hilbert's curve, from the high bits to the low ones: a quadrant's curve is the
// whole one turned, so that it ends beside the beginning of the next. The high bits of a distance
// are those of the high bits of row and column.
constexpr std::uint32_t
hilbert_key(std::uint32_t row, std::uint32_t column, unsigned bits = QuadBits) {
    std::uint32_t key = 0;
    for (unsigned bit = bits; bit-- > 0;) {
        const std::uint32_t right = column >> bit & 1, upper = row >> bit & 1;
        key = key << 2 | (3 * right ^ upper);
        if (upper == 0) {
            if (right == 1) row = ~row, column = ~column;
            std::swap(row, column);
        }
    }
    return key;
}

// Quads along the side of a block, as a power of two.
constexpr unsigned block_size(const RasterOrder& raster) {
    return static_cast<unsigned>(std::countr_zero(raster.tile_width)) - 1;
}
constexpr unsigned outer_block_size(const RasterOrder& raster) {
    return std::max(static_cast<unsigned>(std::countr_zero(raster.outer_tile_width)) - 1,
                    block_size(raster));
}

// Of pixel (x, y): 24 bits, counting up in the order of the walk.
constexpr std::uint32_t traversal_key(const RasterOrder& raster, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t row = y / 2, column = x / 2;
    const unsigned size = block_size(raster), outer = outer_block_size(raster);
    switch (raster.traversal) {
    case Traversal::Scanline:
        return row << QuadBits | column;
    case Traversal::Column:
        return column << QuadBits | row;
    case Traversal::Tiled:
        return squares_key(row, column, size);
    case Traversal::Nested: {
        const std::uint32_t inside = (1u << size) - 1;
        const std::uint32_t tile =
            squares_key(row >> size, column >> size, outer - size, QuadBits - size);
        return tile << 2 * size | (row & inside) << size | (column & inside);
    }
    case Traversal::Morton:
        return morton_key(row, column);
    case Traversal::Hilbert:
        return hilbert_key(row, column);
    }
    return 0;
}

// Low bits of a key that count the quads of a block: the key of a block is what is above them.
constexpr unsigned block_key_bits(const RasterOrder& raster) {
    const bool lines =
        raster.traversal == Traversal::Scanline || raster.traversal == Traversal::Column;
    return lines ? QuadBits : 2 * block_size(raster);
}

constexpr std::uint32_t
traversal_block(const RasterOrder& raster, std::uint32_t x, std::uint32_t y) {
    return traversal_key(raster, x, y) >> block_key_bits(raster);
}

// The same for a fragment: it takes the place of a quad, on a picture of twice the size.
constexpr std::uint64_t
fragment_traversal_key(RasterOrder raster, std::uint32_t x, std::uint32_t y) {
    if (raster.traversal == Traversal::Hilbert) return hilbert_key(y, x, QuadBits + 1);
    raster.tile_width *= 2;
    raster.outer_tile_width *= 2;
    return traversal_key(raster, 2 * x, 2 * y);
}

constexpr std::uint32_t screen_bin(const RasterOrder& raster, std::uint32_t x, std::uint32_t y) {
    return (y / raster.bin_size) << 12 | (x / raster.bin_size);
}

} // namespace ffgpu::work
