#include "model/timing/interpolator_timing.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace ffgpu::timing {

// Quads come in the order of the pieces.
const PieceBox& InterpolatorTiming::piece_of(const QuadToken& token) {
    const std::vector<work::PreparedPiece>& pieces = token.scene->work.pieces;
    if (std::exchange(scene_, token.scene) != token.scene) piece_ = 0;
    while (token.index >= pieces[piece_].end)
        ++piece_;
    return pieces[piece_].box;
}

// A divisor a cycle.
void InterpolatorTiming::take() {
    const bool has_room = waiting_.size() < config_.divide_queue;
    if (!ports_.quads_in.can_pop() || !has_room || now() < takes_at_) return;
    const QuadToken quad = ports_.quads_in.pop();
    const PieceBox& piece = piece_of(quad);
    const Cycle divisors = piece.divisors;
    const Cycle values = piece.values + Cycle{piece.perspective && piece.values > 0};
    waiting_.push_back({quad,
                        now() + (divisors > 0 ? config_.divide_latency : 1),
                        std::max<Cycle>(values * config_.value_cycles, 1)});
    takes_at_ = now() + std::max<Cycle>(divisors, 1);
}

Activity InterpolatorTiming::make_values() {
    if (waiting_.empty() || waiting_.front().ready_at > now()) return Activity::Idle;
    const Waiting& first = waiting_.front();
    if (cycles_left_ == 0) cycles_left_ = first.cycles;
    if (cycles_left_ > 1) {
        --cycles_left_;
        return Activity::Busy;
    }
    if (!ports_.quads_out.can_push()) return Activity::StalledOutput;
    ports_.quads_out.push(first.quad);
    waiting_.pop_front();
    cycles_left_ = 0;
    return Activity::Busy;
}

Activity InterpolatorTiming::step() {
    const Activity activity = make_values();
    take();
    return activity;
}

Cycle InterpolatorTiming::next_work(Activity last) const {
    Cycle next = Unit::next_work(last);
    if (!waiting_.empty() && cycles_left_ == 0)
        next = std::min(next, std::max(waiting_.front().ready_at, now() + 1));
    if (ports_.quads_in.can_pop() && waiting_.size() < config_.divide_queue)
        next = std::min(next, std::max(takes_at_, now() + 1));
    return next;
}

std::string InterpolatorTiming::state() const {
    if (waiting_.empty()) return "no quad";
    return fmt::format("{} quads, the first, {}, with its divisors in cycle {}",
                       waiting_.size(),
                       waiting_.front().quad.key(),
                       waiting_.front().ready_at);
}

} // namespace ffgpu::timing
