#include "model/timing/pipe_watch.h"

#include "model/base/check.h"
#include "model/timing/link.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace ffgpu::timing {
namespace {

constexpr std::uint64_t ArbiterBit = std::uint64_t{1} << 63;

LinkSeen seen(const Link& link) {
    return {static_cast<std::uint32_t>(link.pushed()), static_cast<std::uint32_t>(link.popped())};
}

} // namespace

PipeWatch::PipeWatch(const Clock& clock, const PipeParts& parts)
    : clock_(clock)
    , parts_(parts)
    , taken_(parts.requests.size()) {
    check(parts.stages.size() < 63, "a bit for each stage");
    for (const Stage& stage : parts.stages) {
        Place& place = places_.emplace_back(Place{&stage, StageLinks(stage), {}, {}, {}});
        check(stage.passages.size() <= 64, "a bit for each passage");
        place.passages.resize(stage.passages.size());
        const StageLinks& links = place.links;
        for (const auto* const more : {&links.in, &links.out, &links.asked, &links.answered})
            place.all.insert(place.all.end(), more->begin(), more->end());
        std::ranges::remove_copy_if(
            stage.unit->outputs(), std::back_inserter(place.unit_out), &Link::carries_requests);
        std::uint64_t bits = 0; // of all stages of its unit
        for (std::size_t i = 0; i < parts.stages.size(); ++i)
            bits |= std::uint64_t{parts.stages[i].unit == stage.unit} << i;
        stage.unit->show_calls_in(called_, bits);
    }
    parts.arbiter.show_calls_in(called_, ArbiterBit);
}

void PipeWatch::done(const MemoryRequest& request, std::uint64_t) {
    const Link* const back = parts_.responses[request.port];
    answers_.push_back({request, back ? seen(*back) : LinkSeen{}});
}

void PipeWatch::end_cycle(std::size_t charged, PipeLog& log) {
    const std::uint64_t called = std::exchange(called_, 0);
    if (called == 0 && answers_.empty()) return;
    CycleSeen cycle{.now = clock_.now(),
                    .charged = charged,
                    .answers = static_cast<std::uint32_t>(answers_.size())};
    log.answers.insert(log.answers.end(), answers_.begin(), answers_.end());
    answers_.clear();
    for (std::uint64_t left = called & ~ArbiterBit; left != 0; left &= left - 1) {
        look(static_cast<std::size_t>(std::countr_zero(left)), log);
        ++cycle.stages;
    }
    if ((called & ArbiterBit) != 0 && parts_.arbiter.activity() == Activity::Busy)
        cycle.taken = note_taken(log);
    log.cycles.push_back(cycle);
}

std::uint32_t PipeWatch::note_taken(PipeLog& log) {
    std::uint32_t ports = 0;
    for (std::size_t port = 0; port < taken_.size(); ++port) {
        const Link& link = *parts_.requests[port];
        if (std::exchange(taken_[port], link.popped()) == link.popped()) continue;
        log.taken.push_back({port, seen(link)});
        ++ports;
    }
    return ports;
}

std::uint64_t PipeWatch::note_passages(Place& place, PipeLog& log) {
    std::uint64_t changed = 0;
    for (std::size_t i = 0; i < place.passages.size(); ++i) {
        const Passage& now = *place.stage->passages[i].passage;
        if (place.passages[i] == now) continue;
        place.passages[i] = now;
        log.passages.push_back(now);
        changed |= std::uint64_t{1} << i;
    }
    return changed;
}

void PipeWatch::look(std::size_t place, PipeLog& log) {
    const Cycle now = clock_.now();
    Place& at = places_[place];
    const Stage& stage = *at.stage;
    const auto refuses = [now](const Link* link) { return link->refused_at() == now; };
    log.stages.push_back(
        {.stage = static_cast<std::uint32_t>(place),
         .activity = stage.unit->activity(),
         .refused = std::ranges::any_of(at.links.out, refuses),
         .unit_refused = std::ranges::any_of(at.unit_out, refuses),
         .request_waits = std::ranges::any_of(at.links.asked, refuses),
         .has_backlog = stage.input ? stage.input->arrival() <= now : stage.unit->has_backlog()});
    for (const Link* const link : at.links.in)
        log.arrivals.push_back(link->arrival());
    log.stages.back().passages = note_passages(at, log);
    const std::size_t links = log.links.size();
    log.links.resize(links + at.all.size());
    LinkSeen* next = log.links.data() + links;
    for (const Link* const link : at.all)
        *next++ = seen(*link);
}

} // namespace ffgpu::timing
