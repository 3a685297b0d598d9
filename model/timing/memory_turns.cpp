#include "model/timing/memory_turns.h"

#include <algorithm>

namespace ffgpu::timing {
namespace {

float between(Cycle from, Cycle to) {
    return static_cast<float>(static_cast<std::int64_t>(to - from));
}

} // namespace

Saved MemoryTurns::answer(const Dependence& own, const Dependence& turn, Cycle now, bool has_rare) {
    const Moment& asked = *own.moment;
    const float rest = std::min(slack(own, now), slack(turn, now)), more = slack(own, now) - rest;
    Saved alone = asked.saved;
    alone[own.first.resource] += own.first.cycles;
    alone[own.then.resource] += own.then.cycles;
    for (float& cycles : alone.cycles)
        cycles += more;

    std::array<RequestInTurn::Before, Kept> before;
    std::size_t count = 0;
    float waited = more; // beyond its turn behind all that came before it
    const auto waited_behind = [&](const AnsweredRequest& served) {
        return std::max(between(served.answered, now) - turn.takes, 0.0F) - rest;
    };
    std::array<AnsweredRequest*, Kept> later_ones;
    std::size_t later_count = 0;
    for (std::size_t k = 0; k < Kept; ++k) {
        AnsweredRequest& served = served_[(next_ + k) % Kept];
        if (served.answered == 0) continue;
        if (served.asked > asked.at) {
            later_ones[later_count++] = &served;
            continue;
        }
        const float later = waited_behind(served);
        waited = std::min(waited, later);
        before[count++] = {&served, later, between(served.asked, asked.at), false};
    }
    // One that came later was served first as it was: it goes on to be, but where it comes when
    // this one is done.
    for (AnsweredRequest* const served : std::span(later_ones).first(later_count)) {
        const float sooner = std::max(between(served->asked, now), waited);
        before[count++] = {served, waited_behind(*served), sooner, true};
    }
    const auto [saved, idle] = saved_in_turn({.asked = asked.saved,
                                              .alone = alone,
                                              .takes = turn.takes,
                                              .before = std::span(before).first(count),
                                              .has_rare = has_rare});
    next() = {asked.at, now, asked.saved, saved, idle};
    return saved;
}

void MemoryTurns::note_answer(Cycle asked, const Saved& saved, Cycle now) {
    next() = {asked, now, {}, saved, {}};
}

SavedInTurn saved_in_turn_plainly(const RequestInTurn& request) {
    SavedInTurn result;
    for (std::size_t i = 0; i < Saved::Lanes; ++i) {
        const float alone = request.alone.cycles[i];
        const bool is_bandwidth = i == Saved::lane(Resource::MemoryBandwidth);
        const float of_turn = is_bandwidth ? request.takes : 0;
        float behind = NoTurn;
        float left = request.takes - of_turn; // of its work, which those that it overtakes wait for
        for (const RequestInTurn::Before& each : request.before) {
            AnsweredRequest& served = *each.answered;
            const float mine = each.came_later ? std::min(alone, behind) : request.asked.cycles[i];
            if (mine - served.asked_saved.cycles[i] > each.sooner) {
                const float used = std::min(left, served.idle.cycles[i]);
                served.idle.cycles[i] -= used;
                left -= used;
                served.answer_saved.cycles[i] -= left;
            } else {
                behind = std::min(behind, served.answer_saved.cycles[i] + of_turn + each.later);
            }
        }
        result.answer.cycles[i] = std::min(alone, behind);
        result.idle.cycles[i] = std::max(behind - alone, 0.0F);
    }
    return result;
}

} // namespace ffgpu::timing
