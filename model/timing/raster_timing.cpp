#include "model/timing/raster_timing.h"

#include <algorithm>
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
    take_scene(*token.pass.scene);
    bin_ = token.bin;
    take_pieces(token.plan().pieces_begin, token.plan().pieces_end);
}

void RasterTiming::take(const SetupToken& token) {
    take_scene(*token.draw.scene);
    take_pieces(token.begin, token.end);
    ends_draw_ = token.last;
    draw_ = token.draw.draw;
    if (piece_ == end_piece_) end_record();
}

void RasterTiming::take_scene(TimedScene& scene) {
    scene_ = &scene;
    may_starve_ = scene.waits_for_quads();
    if (std::exchange(scene_number_, scene.number) != scene.number) part_ = nullptr;
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
    may_starve_ = true; // of the next one's scene
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
    const work::PreparedPiece& piece = scene_->work.pieces[piece_];
    std::uint32_t made = 0;
    for (; made < config_.quads_per_cycle && quad_ != piece.end; ++made) {
        const TimedPart& part = part_with_quad();
        const std::uint32_t index = quad_ - part.first;
        const PreparedQuad& quad = part.work.quads[index];
        // Another thread wrote them: they come from another processor's cache.
        if (part.has(quad_ + QuadsAhead)) __builtin_prefetch(&quad + QuadsAhead);
        // The way to another block begins in the cycle after the quads of this one.
        if (made > 0 && quad.new_tile && cycles_to(quad) > 0) break;
        if (!step_to_block(quad)) return Activity::Busy;
        if (!ports_.quads_out.can_push())
            return made > 0 ? Activity::Busy : Activity::StalledOutput;
        ports_.quads_out.push({&part, index, 0});
        in_block_ = false;
        ++quad_;
    }
    const bool nothing_behind = piece.empty_blocks == 0 || config_.empty_tile_cycles == 0;
    if (quad_ == piece.end && (made == 0 || nothing_behind)) end_piece(piece);
    return Activity::Busy;
}

const TimedPart& RasterTiming::part_with_quad() {
    if (!part_ || !part_->has(quad_)) part_ = &scene_->part_of(quad_);
    return *part_;
}

// Of the piece's quads from `quad` to `end`, in a cycle. A walk over whole tiles looks at all.
bool RasterTiming::starves(const TimedScene& scene, std::uint32_t quad, std::uint32_t end) const {
    const bool looks_at_all = config_.walk == Walk::Tiles;
    return scene.told_quads() <
           (looks_at_all ? end : std::min(quad + config_.quads_per_cycle, end));
}

bool RasterTiming::starves() const {
    if (config_.architecture == Architecture::TileBased) return false; // The scene was gathered.
    if (piece_ != end_piece_) return starves(*scene_, quad_, scene_->work.pieces[piece_].end);
    if (ports_.setups_in.items() == 0) return false;
    const SetupToken& next = ports_.setups_in.next();
    if (next.begin == next.end) return false;
    const work::PreparedPiece& piece = next.draw.scene->work.pieces[next.begin];
    return starves(*next.draw.scene, piece.begin, piece.end);
}

Activity RasterTiming::step() {
    const Activity activity = walk();
    if (may_starve_ && starves()) ask_whether_to_wait();
    return activity;
}

Activity RasterTiming::walk() {
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
