#include "model/timing/setup_timing.h"

#include <algorithm>

namespace ffgpu::timing {

// The pieces of a tile-based machine are sorted by bins: set-up does not see them.
Cycle SetupTiming::piece_cycles(const SetupToken& record) const {
    const SetupConfig& setup = config_.setup;
    Cycle cycles = setup.triangle_cycles +
                   Cycle{setup.attribute_cycles} * record.draw.prepared().geometry.interpolants;
    if (setup.plane_cycles > 0)
        cycles +=
            Cycle{setup.plane_cycles} * record.draw.scene->work.pieces[record.begin].box.planes;
    return cycles;
}

// Set-up knows that it covers nothing, and a rasterizer that walks tiles does not see it.
bool SetupTiming::drops(const SetupToken& record) const {
    if (config_.raster.walk == Walk::Box) return false;
    const work::PreparedPiece& piece = record.draw.scene->work.pieces[record.begin];
    return piece.begin == piece.end && !piece.box.handed_on;
}

// A free unit takes the next piece, or a primitive without any.
bool SetupTiming::begin_next() {
    if (units_.size() == config_.setup.units || !ports_.primitives_in.can_pop()) return false;
    const PrimitiveToken& token = ports_.primitives_in.front();
    SetupToken record{token.draw, 0, 0, token.last};
    Cycle cycles = config_.setup.reject_cycles;
    if (token.primitive == PrimitiveToken::None) {
        cycles = 1;
    } else if (const work::PreparedPrimitive& primitive = token.prepared();
               primitive.piece_count > 0) {
        record.begin = primitive.first_piece + next_piece_;
        record.end = record.begin + 1;
        if (drops(record)) {
            record.end = record.begin;
        } else {
            cycles = piece_cycles(record);
        }
        const bool is_last_piece = ++next_piece_ == primitive.piece_count;
        record.last = token.last && is_last_piece;
        units_.push_back({record, now() + cycles - 1});
        passage_.enter_unit(cycles);
        if (!is_last_piece) return true;
        next_piece_ = 0;
        ports_.primitives_in.pop();
        return true;
    }
    units_.push_back({record, now() + cycles - 1});
    passage_.enter_unit(cycles);
    ports_.primitives_in.pop();
    return true;
}

bool SetupTiming::send_next() {
    if (units_.empty() || now() < units_.front().done_at) return false;
    const SetupToken& record = units_.front().record;
    // What covers nothing ends here, but for the draw's end that it may carry.
    const bool ends_here = record.begin == record.end && !record.last;
    if (!ends_here && !ports_.setups_out.can_push()) return false;
    if (!ends_here) ports_.setups_out.push(record);
    if (record.draw.scene->waits_for_quads()) ask_whether_to_wait();
    units_.pop_front();
    passage_.leave();
    return true;
}

// Where nothing can begin, all cycles until the first is done are busy.
void SetupTiming::sleep_until_done() {
    const bool waits = ports_.primitives_in.can_pop();
    if (units_.empty() && !waits) rest_as(Activity::Idle);
    if (units_.empty() || (waits && units_.size() < config_.setup.units)) return;
    next_change_ = units_.front().done_at;
}

Activity SetupTiming::step() {
    next_change_ = 0;
    bool moved = false;
    for (std::uint32_t i = 0; i < config_.setup.units && begin_next(); ++i)
        moved = true;
    for (std::uint32_t i = 0; i < config_.setup.units && send_next(); ++i)
        moved = true;
    if (moved) {
        sleep_until_done();
        return Activity::Busy;
    }
    if (units_.empty()) return Activity::Idle;
    Cycle next_change = Never;
    for (std::size_t i = 0; i < units_.size(); ++i)
        if (now() < units_[i].done_at) next_change = std::min(next_change, units_[i].done_at);
    if (next_change == Never) return Activity::StalledOutput;
    next_change_ = next_change;
    return Activity::Busy;
}

} // namespace ffgpu::timing
