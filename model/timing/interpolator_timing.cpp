#include "model/timing/interpolator_timing.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace ffgpu::timing {

// Quads come in the order of the pieces.
const PieceBox& InterpolatorTiming::piece_of(const QuadToken& token) {
    const std::vector<work::PreparedPiece>& pieces = token.scene().work.pieces;
    if (std::exchange(scene_, token.scene().number) != token.scene().number) piece_ = 0;
    while (token.number() >= pieces[piece_].end)
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
                        std::max<Cycle>(values * config_.value_cycles, 1),
                        piece.values});
    ++passage_.entered;
    takes_at_ = now() + std::max<Cycle>(divisors, 1);
}

// Of the values that are under way there is room for one more.
bool InterpolatorTiming::has_place() {
    if (config_.value_places == 0) return true;
    for (; arrived_ < ports_.quads_out.popped_before(); ++arrived_) {
        sent_values_ -= sent_.front();
        sent_.pop_front();
    }
    const Waiting& first = waiting_.front();
    const Cycle cycles = cycles_left_ > 0 ? cycles_left_ : first.cycles;
    const Cycle values_left = (cycles + config_.value_cycles - 1) / config_.value_cycles;
    if (values_left > first.values) return true; // It is w.
    const Cycle made = first.values - values_left;
    const std::uint32_t collected = sent_.empty() ? first.values : sent_.front();
    if (sent_values_ + made < config_.value_places + std::max(collected, 1u) - 1) return true;
    ports_.quads_out.await_pop();
    return false;
}

Activity InterpolatorTiming::make_values() {
    if (waiting_.empty() || waiting_.front().ready_at > now()) return Activity::Idle;
    const Waiting& first = waiting_.front();
    if (!has_place()) return Activity::StalledOutput;
    if (cycles_left_ == 0) cycles_left_ = first.cycles;
    if (cycles_left_ > 1) {
        --cycles_left_;
        ++passage_.worked;
        return Activity::Busy;
    }
    if (!ports_.quads_out.can_push()) return Activity::StalledOutput;
    ports_.quads_out.push(first.quad);
    if (config_.value_places > 0) {
        sent_.push_back(first.values);
        sent_values_ += first.values;
    }
    waiting_.pop_front();
    ++passage_.worked;
    passage_.leave();
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
