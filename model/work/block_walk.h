// Which blocks a rasterizer walks for one piece of a primitive: those that its box of pixels
// touches, and no others, in the order of the traversal. A block without a covered sample is
// walked like any other.
//
// A block is a square of tile_width pixels; scan line and column walk rows and columns of quads
// from end to end of the box, and a block is such a row or column.

#pragma once

#include "model/packets/work_stream.h"
#include "model/work/config.h"

#include <cstdint>

namespace ffgpu::work {

class BlockWalk {
public:
    // An empty box has no blocks.
    BlockWalk(const RasterOrder& raster, const PieceBox& box);

    std::uint32_t blocks() const { return width_ * height_; }

    // How many blocks are walked before that of pixel (x, y), which must be one of them.
    std::uint32_t before(std::uint32_t x, std::uint32_t y) const;

private:
    struct Square {
        std::uint32_t row = 0, column = 0, size = 1; // in blocks
    };

    std::uint32_t inside(std::uint32_t row, std::uint32_t column, Square square) const;
    std::uint32_t before_in_squares(std::uint32_t row, std::uint32_t column) const;
    std::uint32_t before_on_curve(std::uint32_t row, std::uint32_t column) const;

    RasterOrder raster_;
    unsigned row_shift_ = 0, column_shift_ = 0; // pixels to blocks
    std::uint32_t row_ = 0, column_ = 0;        // the box's first block
    std::uint32_t width_ = 0, height_ = 0;      // in blocks
};

} // namespace ffgpu::work
