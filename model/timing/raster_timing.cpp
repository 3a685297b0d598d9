#include "model/timing/raster_timing.h"

#include <algorithm>

namespace ffgpu::timing {

const TimedPart& RasterTiming::Quads::find(const TimedScene& scene, std::uint32_t quad) {
    scene_ = scene.number;
    part_ = &scene.part_of(quad);
    return *part_;
}

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
    record_ = {token.pass.scene, token.bin};
    take_pieces(token.plan().pieces_begin, token.plan().pieces_end);
}

void RasterTiming::take(const SetupToken& token) {
    record_ = {token.draw.scene, token.draw.draw, token.last};
    take_pieces(token.begin, token.end);
}

void RasterTiming::take_pieces(std::uint32_t begin, std::uint32_t end) {
    piece_ = begin;
    end_piece_ = end;
    if (begin == end) return;
    const auto& pieces = record_.scene->work.pieces;
    in_flight_.enter(pieces[end - 1].end - pieces[begin].begin);
}

// The draw itself is through: its quads are counted now. Or the bin is.
void RasterTiming::end_record(const Record& record) {
    if (config_.architecture == Architecture::TileBased)
        return record.scene->end_walk(record.number, now());
    if (!record.ends_draw) return;
    in_flight_.leave();
    record.scene->end_draw(record.number, now());
}

bool RasterTiming::starves() {
    // A tile-based machine's scene was gathered.
    if (config_.architecture == Architecture::TileBased) return false;
    return config_.walk == Walk::Tiles ? starves_in_tiles() : starves_in_box();
}

bool RasterTiming::next_token_has_come() const {
    return config_.architecture == Architecture::TileBased ? ports_.bins_in.can_pop()
                                                           : ports_.setups_in.can_pop();
}

// What could be taken in the next cycle, and begun.
bool RasterTiming::next_token_starves() const {
    if (ports_.setups_in.items() == 0) return false;
    const SetupToken& next = ports_.setups_in.next();
    if (next.begin == next.end) return false;
    const TimedScene& scene = *next.draw.scene;
    const work::PreparedPiece& piece = scene.work.pieces[next.begin];
    return starves_at(scene, piece.begin, piece.end);
}

// Of the piece's quads from `quad` to `end`, in a cycle; the one behind tells whether the block
// ends. A walk over whole tiles looks at all.
bool RasterTiming::starves_at(const TimedScene& scene,
                              std::uint32_t quad,
                              std::uint32_t end) const {
    const bool looks_at_all = config_.walk == Walk::Tiles;
    return scene.told_quads() <
           (looks_at_all ? end : std::min(quad + config_.quads_per_cycle + 1, end));
}

Activity RasterTiming::step() {
    const Activity activity = config_.walk == Walk::Tiles ? step_tiles() : step_box();
    if (starves()) ask_whether_to_wait();
    return activity;
}

Cycle RasterTiming::next_work(Activity last) const {
    return config_.walk == Walk::Tiles ? next_in_tiles(last) : next_in_box(last);
}

} // namespace ffgpu::timing
