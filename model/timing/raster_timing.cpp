#include "model/timing/raster_timing.h"

#include <utility>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t QuadsAhead = 8; // that are on their way from memory

} // namespace

bool RasterTiming::take() {
    if (config_.architecture == Architecture::TileBased) {
        if (!ports_.bins_in.can_pop()) return false;
        take(ports_.bins_in.pop());
    } else {
        if (!ports_.setups_in.can_pop()) return false;
        take(ports_.setups_in.pop());
    }
    return true;
}

void RasterTiming::take(const BinToken& token) {
    scene_ = token.pass.scene;
    bin_ = token.bin;
    take_pieces(token.plan().pieces_begin, token.plan().pieces_end);
}

void RasterTiming::take(const SetupToken& token) {
    scene_ = token.draw.scene;
    take_pieces(token.begin, token.end);
    ends_draw_ = token.last;
    draw_ = token.draw.draw;
    if (piece_ == end_piece_) end_record();
}

void RasterTiming::take_pieces(std::uint32_t begin, std::uint32_t end) {
    piece_ = begin;
    end_piece_ = end;
    if (begin == end) return;
    const auto& pieces = scene_->work.pieces;
    quad_ = pieces[begin].begin;
    in_flight_.enter(pieces[end - 1].end - quad_);
}

// The draw itself is through: its quads are counted now. Or the bin is.
void RasterTiming::end_record() {
    if (config_.architecture == Architecture::TileBased) return scene_->end_walk(bin_, now());
    if (!std::exchange(ends_draw_, false)) return;
    in_flight_.leave();
    scene_->end_draw(draw_, now());
}

Cycle RasterTiming::cycles_to(const PreparedQuad& quad) const {
    return Cycle{quad.empty_blocks} * config_.empty_tile_cycles + config_.tile_cycles;
}

// True where the quad can be made now; else the walk to its block begins.
bool RasterTiming::step_to_block(const PreparedQuad& quad) {
    if (!quad.new_tile || in_block_) return true;
    in_block_ = true;
    ++statistics_.blocks;
    statistics_.empty_blocks += quad.empty_blocks;
    walked_at_ = now() + cycles_to(quad);
    return walked_at_ == now();
}

// All its quads are made: what is left are empty blocks.
void RasterTiming::end_piece(const work::PreparedPiece& piece) {
    statistics_.empty_blocks += piece.empty_blocks;
    walked_at_ = now() + Cycle{piece.empty_blocks} * config_.empty_tile_cycles;
    if (++piece_ != end_piece_)
        quad_ = scene_->work.pieces[piece_].begin;
    else if (walked_at_ <= now() + 1)
        end_record();
}

Activity RasterTiming::walk_piece() {
    const work::PreparedScene& work = scene_->work;
    const work::PreparedPiece& piece = work.pieces[piece_];
    std::uint32_t made = 0;
    for (; made < config_.quads_per_cycle && quad_ != piece.end; ++made) {
        const PreparedQuad& quad = work.quads[quad_];
        // Another thread wrote them: they come from another processor's cache.
        if (quad_ + QuadsAhead < work.quads.size())
            __builtin_prefetch(&work.quads[quad_ + QuadsAhead]);
        // The way to another block begins in the cycle after the quads of this one.
        if (made > 0 && quad.new_tile && cycles_to(quad) > 0) break;
        if (!step_to_block(quad)) return Activity::Busy;
        if (!ports_.quads_out.can_push())
            return made > 0 ? Activity::Busy : Activity::StalledOutput;
        ports_.quads_out.push({scene_, quad_, 0});
        in_block_ = false;
        ++quad_;
    }
    const bool nothing_behind = piece.empty_blocks == 0 || config_.empty_tile_cycles == 0;
    if (quad_ == piece.end && (made == 0 || nothing_behind)) end_piece(piece);
    return Activity::Busy;
}

Activity RasterTiming::step() {
    if (now() < walked_at_) {
        if (piece_ == end_piece_ && now() + 1 == walked_at_) end_record();
        return Activity::Busy;
    }
    if (piece_ == end_piece_) {
        if (!take()) return Activity::Idle;
        if (piece_ == end_piece_) return Activity::Busy;
    }
    return config_.walk == Walk::Tiles ? walk_tiles() : walk_piece();
}

Cycle RasterTiming::next_work(Activity last) const {
    if (now() + 1 >= walked_at_) return Unit::next_work(last);
    return piece_ == end_piece_ ? walked_at_ - 1 : walked_at_;
}

} // namespace ffgpu::timing
