// The walk over the blocks of pieces' boxes, and the making of the quads of those that it has come
// to. In a cycle the walk comes first.

#include "model/timing/raster_timing.h"

#include <algorithm>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t QuadsAhead = 8; // that are on their way from memory

} // namespace

Cycle RasterTiming::cycles_to(const PreparedQuad& quad) const {
    return Cycle{quad.empty_blocks} * config_.empty_tile_cycles + config_.tile_cycles;
}

// To pass the blocks behind the piece's last quad, which are told with that. A piece without quads
// takes a cycle at least.
Cycle RasterTiming::empty_cycles_behind(const work::PreparedPiece& piece) const {
    const Cycle cycles = Cycle{piece.empty_blocks} * config_.empty_tile_cycles;
    return piece.begin == piece.end ? std::max<Cycle>(cycles, 1) : cycles;
}

// next_ goes on to the first quad of the next block, or to the piece's end; false: those up to
// there are not told.
bool RasterTiming::look_for_next_block() {
    const TimedScene& scene = *record_.scene;
    const std::uint32_t end = std::min(piece().end, scene.told_quads());
    while (next_ != end) {
        const TimedPart& part = walked_.part_with(scene, next_);
        const std::uint32_t part_end = std::min(part.end, end);
        const PreparedQuad* quad = &part.work.quads[next_ - part.first];
        for (; next_ != part_end; ++next_, ++quad)
            if (quad->new_tile) return is_found_ = true;
    }
    return is_found_ = next_ == piece().end;
}

void RasterTiming::walk() {
    while (now() >= walked_at_ && blocks_.size() < config_.block_queue) {
        if (piece_ == end_piece_) {
            if (!take()) return;
            if (piece_ == end_piece_) return begin_empty(1);
            begin_piece();
        }
        check(find_next_block(), "the walk has come to quads that were not told");
        if (next_ != piece().end) {
            if (!begin_block()) return;
            continue;
        }
        statistics_.empty_blocks += piece().empty_blocks;
        if (const Cycle cycles = empty_cycles_behind(piece()); cycles > 0) begin_empty(cycles);
        if (++piece_ != end_piece_) begin_piece();
    }
}

void RasterTiming::begin_piece() {
    next_ = piece().begin;
    is_found_ = false;
}

const PreparedQuad& RasterTiming::first_of_next_block() {
    const TimedPart& part = walked_.part_with(*record_.scene, next_);
    return part.work.quads[next_ - part.first];
}

// The walk to the one at next_. False: it takes no time; it begins when its quads can be made.
bool RasterTiming::begin_block() {
    const PreparedQuad& quad = first_of_next_block();
    const Cycle cycles = cycles_to(quad);
    if (cycles == 0) return false;
    push_block(quad, cycles);
    return true;
}

void RasterTiming::push_block(const PreparedQuad& quad, Cycle cycles) {
    ++statistics_.blocks;
    statistics_.empty_blocks += quad.empty_blocks;
    walked_at_ = now() + cycles;
    blocks_.push_back({.record = record_,
                       .quad = next_,
                       .end = piece().end,
                       .ready_at = walked_at_,
                       .begins_piece = next_ == piece().begin,
                       .piece = piece_,
                       .is_of_last_piece = piece_ + 1 == end_piece_});
    passage_.enter_unit(cycles);
    ++next_;
    is_found_ = false;
}

// Or a token without pieces, of which a tile-based machine's was over before.
void RasterTiming::begin_empty(Cycle cycles) {
    const bool has_pieces = piece_ != end_piece_;
    walked_at_ = now() + cycles;
    blocks_.push_back({.record = record_,
                       .ready_at = walked_at_,
                       .is_empty = true,
                       .is_of_last_piece = has_pieces
                                               ? piece_ + 1 == end_piece_
                                               : config_.architecture == Architecture::Immediate});
    passage_.enter_unit(cycles);
}

// All blocks that were begun are made. One to which the walk takes no time is begun now, unless it
// is another piece's than the quads of this cycle.
bool RasterTiming::begin_free_block(bool made) {
    if (now() < walked_at_ || piece_ == end_piece_ || next_ == piece().end) return false;
    if (made && next_ == piece().begin) return false;
    check(find_next_block(), "the walk has come to quads that were not told");
    if (next_ == piece().end || cycles_to(first_of_next_block()) > 0) return false;
    push_block(first_of_next_block(), 0);
    return true;
}

// As many of its quads as the cycle has room for. True: it has none left.
bool RasterTiming::make_block(Block& block, std::uint32_t& made) {
    const TimedScene& scene = *block.record.scene;
    const TimedPart* part = &made_.part_with(scene, block.quad);
    while (made < config_.quads_per_cycle && ports_.quads_out.can_push()) {
        const std::uint32_t index = block.quad - part->first;
        // Another thread wrote them: they come from another processor's cache.
        if (part->has(block.quad + QuadsAhead))
            __builtin_prefetch(&part->work.quads[index + QuadsAhead]);
        ports_.quads_out.push({part, index, 0});
        ++made;
        block.begins_piece = false;
        if (++block.quad == block.end) return true;
        if (!part->has(block.quad)) part = &made_.part_with(scene, block.quad);
        if (part->work.quads[block.quad - part->first].new_tile) return true;
    }
    return false;
}

// Of a block that was made, or passed. The empty ones behind a piece's last quads have a place of
// their own in the queue.
bool RasterTiming::ends_record(const Block& block) const {
    if (!block.is_of_last_piece || block.quad != block.end) return false;
    return block.is_empty || empty_cycles_behind(block.record.scene->work.pieces[block.piece]) == 0;
}

void RasterTiming::leave_block() {
    const Block& block = blocks_.front();
    if (ends_record(block)) end_record(block.record);
    blocks_.pop_front();
    passage_.leave();
}

// Those that were walked to, quads_per_cycle of one piece.
RasterTiming::Made RasterTiming::make_quads() {
    const std::uint32_t most = config_.quads_per_cycle;
    std::uint32_t made = 0;
    bool passed = false;
    while (!blocks_.empty() || (made < most && begin_free_block(made > 0))) {
        Block& block = blocks_.front();
        if (block.is_empty) { // Such are passed in the walk's last cycle.
            if (now() + 1 < block.ready_at) break;
            leave_block();
            passed = true;
            continue;
        }
        if (now() < block.ready_at || made == most || (made > 0 && block.begins_piece)) break;
        if (!make_block(block, made)) {
            if (made == 0 && !passed) return Made::Refused;
            break;
        }
        leave_block();
    }
    passage_.worked += made > 0;
    return made > 0 || passed ? Made::Something : Made::Nothing;
}

Activity RasterTiming::step_box() {
    walk();
    const Made made = make_quads();
    if (made == Made::Refused) return Activity::StalledOutput;
    const bool works = made == Made::Something || !blocks_.empty() || now() < walked_at_;
    return works ? Activity::Busy : Activity::Idle;
}

// In the next cycle it could come to what was not told.
bool RasterTiming::starves_in_box() {
    if (!blocks_.empty()) {
        const Block& block = blocks_.front();
        if (!block.is_empty && starves_at(*block.record.scene, block.quad, block.end)) return true;
    }
    if (piece_ == end_piece_) return next_token_starves();
    if (!find_next_block()) return true;
    if (next_ != piece().end) return starves_at(*record_.scene, next_, piece().end);
    return piece_ + 1 == end_piece_ && next_token_starves();
}

Cycle RasterTiming::next_in_box(Activity last) const {
    const Cycle soon = now() + 1;
    if (blocks_.empty()) return Unit::next_work(last);
    Cycle next = Never;
    const Block& block = blocks_.front();
    const Cycle ready_at = block.ready_at - (block.is_empty ? 1 : 0);
    // Who is refused is woken.
    if (ready_at > now() || last != Activity::StalledOutput) next = std::max(soon, ready_at);
    const bool goes_on = piece_ != end_piece_ || next_token_has_come();
    if (goes_on && blocks_.size() < config_.block_queue)
        next = std::min(next, std::max(soon, walked_at_));
    return next;
}

} // namespace ffgpu::timing
