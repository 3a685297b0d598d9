// PieceWalk: the walk of a piece's blocks (block_walk.h), as it comes to the piece's quads.

#pragma once

#include "model/base/check.h"
#include "model/work/block_walk.h"
#include "model/work/prepared_work.h"
#include "model/work/traversal.h"

#include <cstdint>

namespace ffgpu::work {

class PieceWalk {
public:
    // Where the box is empty only blocks with quads are walked.
    PieceWalk(const RasterOrder& raster, const PieceBox& box)
        : raster_(raster)
        , walk_(raster, box)
        , has_box_(!box.empty()) {}

    // Tells the quad whether a block begins with it, and how many empty ones are walked before.
    // They come in the traversal's order.
    void come_to(PreparedQuad& quad) {
        const std::uint32_t block = traversal_block(raster_, quad.x, quad.y);
        quad.new_tile = is_first_ || block != block_;
        quad.empty_blocks = 0;
        is_first_ = false;
        block_ = block;
        if (!quad.new_tile || !has_box_) return;
        const std::uint32_t before = walk_.before(quad.x, quad.y);
        check(before >= walked_, "quads come in the order of the walk");
        quad.empty_blocks = before - walked_;
        walked_ = before + 1;
    }

    // Those that are walked behind the last block with quads.
    std::uint32_t empty_behind() const { return walk_.blocks() - walked_; }

private:
    RasterOrder raster_;
    BlockWalk walk_;
    bool has_box_ = false, is_first_ = true;
    std::uint32_t block_ = 0;  // of the last quad
    std::uint32_t walked_ = 0; // blocks
};

} // namespace ffgpu::work
