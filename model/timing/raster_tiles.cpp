// The walk over whole tiles. Quads are found where they lie in the scan of their block. Which of
// the blocks without quads the edges touch is not known, but how many: they are taken to lie evenly
// between the others.

#include "model/timing/raster_timing.h"

#include <algorithm>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t QuadsAcross = PieceBox::BlockWidth / 2; // a block
constexpr std::uint32_t BlockQuads = QuadsAcross * QuadsAcross;

std::uint32_t tiles_between(std::uint32_t begin, std::uint32_t end, std::uint32_t width) {
    return (end - 1) / width - begin / width + 1;
}

std::uint32_t place_in_block(const PreparedQuad& quad) {
    return quad.y / 2u % QuadsAcross * QuadsAcross + quad.x / 2u % QuadsAcross;
}

} // namespace

// A cycle each: tiles, all their blocks, and the quads of those that are touched.
void RasterTiming::begin_tiles() {
    const PieceBox& box = piece().box;
    const std::uint32_t width = config_.outer_tile_width;
    const std::uint32_t across = width / PieceBox::BlockWidth;
    const Cycle tiles = box.empty() ? 0
                                    : Cycle{tiles_between(box.x0, box.x1, width)} *
                                          tiles_between(box.y0, box.y1, width);
    walk_ = {.begun = true,
             .cycles_left = config_.piece_cycles + tiles * (1 + Cycle{across} * across) +
                            Cycle{box.touched_blocks} * BlockQuads,
             .empty = piece().empty_blocks,
             .touched = box.touched_blocks,
             .quad = piece().begin};
    walk_.cycles_left = std::max<Cycle>(walk_.cycles_left, 1);
    for (std::uint32_t i = piece().begin; i != piece().end; ++i) {
        const TimedPart& part = walked_.part_with(*record_.scene, i);
        const PreparedQuad& quad = part.work.quads[i - part.first];
        if (!quad.new_tile) continue;
        walk_.empty += quad.empty_blocks;
        walk_.touched -= std::min<std::uint64_t>(walk_.touched, 1);
    }
}

// Tiles and blocks up to the quad's own, from the box's first tile on.
Cycle RasterTiming::steps_to(const PieceBox& box, const PreparedQuad& quad) const {
    const std::uint32_t width = config_.outer_tile_width;
    const std::uint32_t across = width / PieceBox::BlockWidth;
    const Cycle tiles =
        Cycle{quad.y / width - box.y0 / width} * tiles_between(box.x0, box.x1, width) +
        (quad.x / width - box.x0 / width);
    const std::uint32_t block =
        quad.y % width / PieceBox::BlockWidth * across + quad.x % width / PieceBox::BlockWidth;
    return tiles * (1 + Cycle{across} * across) + 1 + block + 1;
}

// Cycles before the one in which the quad is found.
Cycle RasterTiming::scan_to(const PieceBox& box, const PreparedQuad& quad) {
    const std::uint32_t place = place_in_block(quad);
    Cycle cycles = place - walk_.scanned;
    if (quad.new_tile) {
        walk_.passed_empty += quad.empty_blocks;
        const std::uint64_t touched =
            walk_.empty == 0 ? 0 : walk_.touched * walk_.passed_empty / walk_.empty;
        const Cycle steps = box.empty() ? walk_.steps + 1 : steps_to(box, quad);
        const std::uint32_t rest = walk_.scanned == 0 ? 0 : BlockQuads - walk_.scanned;
        cycles =
            rest + (steps - walk_.steps) + (touched - walk_.passed_touched) * BlockQuads + place;
        if (walk_.steps == 0) cycles += config_.piece_cycles;
        walk_.steps = steps;
        walk_.passed_touched = touched;
    }
    walk_.scanned = place + 1;
    return cycles;
}

// A piece is taken when the last quad of the one before stands no more at the door: a place is free
// beside the one that another quad would come to.
bool RasterTiming::last_quad_has_left() const {
    return ports_.quads_out.can_push(std::min<std::size_t>(2, ports_.quads_out.places()));
}

Activity RasterTiming::step_tiles() {
    if (now() < walked_at_) {
        if (piece_ == end_piece_ && now() + 1 == walked_at_) end_record(record_);
        return Activity::Busy;
    }
    if (piece_ == end_piece_) {
        if (!take()) return Activity::Idle;
        if (piece_ == end_piece_) { // A token without pieces: of a tile-based machine it was over.
            if (config_.architecture == Architecture::Immediate) end_record(record_);
            return Activity::Busy;
        }
    }
    return walk_tiles();
}

Activity RasterTiming::walk_tiles() {
    if (!walk_.begun) {
        if (!last_quad_has_left()) return Activity::StalledOutput;
        begin_tiles();
    }
    if (walk_.quad == piece().end) { // It holds none.
        walked_at_ = now() + walk_.cycles_left;
        end_tiles();
        return Activity::Busy;
    }
    const TimedPart& part = walked_.part_with(*record_.scene, walk_.quad);
    const std::uint32_t index = walk_.quad - part.first;
    const PreparedQuad& quad = part.work.quads[index];
    if (!walk_.is_found) {
        const Cycle before = scan_to(piece().box, quad);
        walk_.is_found = true;
        walk_.cycles_left -= std::min(walk_.cycles_left, before + 1);
        walked_at_ = now() + before;
        if (before > 0) return Activity::Busy;
    }
    if (!ports_.quads_out.can_push()) return Activity::StalledOutput;
    ports_.quads_out.push({&part, index, 0});
    statistics_.blocks += quad.new_tile;
    walk_.is_found = false;
    if (++walk_.quad == piece().end) {
        walked_at_ = now() + 1 + walk_.cycles_left;
        end_tiles();
    }
    return Activity::Busy;
}

void RasterTiming::end_tiles() {
    walk_.begun = false;
    if (++piece_ == end_piece_ && walked_at_ <= now() + 1) end_record(record_);
}

bool RasterTiming::starves_in_tiles() const {
    if (piece_ == end_piece_) return next_token_starves();
    const std::uint32_t quad = walk_.begun ? walk_.quad : piece().begin;
    return starves_at(*record_.scene, quad, piece().end);
}

Cycle RasterTiming::next_in_tiles(Activity last) const {
    if (now() + 1 >= walked_at_) return Unit::next_work(last);
    return piece_ == end_piece_ ? walked_at_ - 1 : walked_at_;
}

} // namespace ffgpu::timing
