#include "model/work/block_walk.h"

#include "model/work/traversal.h"

namespace ffgpu::work {
namespace {

constexpr unsigned AllBits = QuadBits + 1; // A block is a whole row: its column is 0.

// Places of [begin, begin + count) that lie in [low, high).
std::uint32_t
overlap(std::uint32_t begin, std::uint32_t count, std::uint32_t low, std::uint32_t high) {
    const std::uint32_t from = std::max(begin, low), to = std::min(begin + count, high);
    return from < to ? to - from : 0;
}

} // namespace

BlockWalk::BlockWalk(const RasterOrder& raster, const PieceBox& box)
    : raster_(raster) {
    row_shift_ = column_shift_ = block_size(raster) + 1;
    if (raster.traversal == Traversal::Scanline) row_shift_ = 1, column_shift_ = AllBits;
    if (raster.traversal == Traversal::Column) row_shift_ = AllBits, column_shift_ = 1;
    row_ = box.y0 >> row_shift_;
    column_ = box.x0 >> column_shift_;
    if (box.empty()) return;
    height_ = ((box.y1 - 1u) >> row_shift_) - row_ + 1;
    width_ = ((box.x1 - 1u) >> column_shift_) - column_ + 1;
}

std::uint32_t BlockWalk::before(std::uint32_t x, std::uint32_t y) const {
    const std::uint32_t row = y >> row_shift_, column = x >> column_shift_;
    switch (raster_.traversal) {
    case Traversal::Nested:
        return before_in_squares(row, column);
    case Traversal::Morton:
    case Traversal::Hilbert:
        return before_on_curve(row, column);
    default:
        return (row - row_) * width_ + (column - column_);
    }
}

// Blocks of the box that lie in the square and before (row, column) of it, row by row.
std::uint32_t BlockWalk::inside(std::uint32_t row, std::uint32_t column, Square square) const {
    const std::uint32_t width = overlap(square.column, square.size, column_, column_ + width_);
    const std::uint32_t rows = overlap(square.row, row - square.row, row_, row_ + height_);
    return rows * width + overlap(square.column, column - square.column, column_, column_ + width_);
}

std::uint32_t BlockWalk::before_in_squares(std::uint32_t row, std::uint32_t column) const {
    const unsigned shift = outer_block_size(raster_) - block_size(raster_);
    const std::uint32_t size = 1u << shift;
    const Square own{row >> shift << shift, column >> shift << shift, size};
    const std::uint32_t rows_of_squares = overlap(0, own.row, row_, row_ + height_) * width_;
    const std::uint32_t squares = overlap(own.row, size, row_, row_ + height_) *
                                  overlap(0, own.column, column_, column_ + width_);
    return rows_of_squares + squares + inside(row, column, own);
}

// From the largest quadrants down: those of the curve before the block's own.
std::uint32_t BlockWalk::before_on_curve(std::uint32_t row, std::uint32_t column) const {
    const auto key = [&](std::uint32_t r, std::uint32_t c, unsigned bits) {
        return raster_.traversal == Traversal::Morton ? morton_key(r, c) : hilbert_key(r, c, bits);
    };
    std::uint32_t blocks = 0;
    const unsigned levels = QuadBits - block_size(raster_);
    for (unsigned level = 0; level < levels; ++level) {
        const unsigned bits = levels - level; // of the coordinates of squares of 2^level blocks
        const std::uint32_t r = row >> level, c = column >> level;
        const std::uint32_t own = key(r, c, bits);
        for (unsigned sibling = 0; sibling < 4; ++sibling) {
            const std::uint32_t other_row = (r & ~1u) | sibling >> 1;
            const std::uint32_t other_column = (c & ~1u) | (sibling & 1);
            if (key(other_row, other_column, bits) >= own) continue;
            blocks += overlap(other_row << level, 1u << level, row_, row_ + height_) *
                      overlap(other_column << level, 1u << level, column_, column_ + width_);
        }
    }
    return blocks;
}

} // namespace ffgpu::work
