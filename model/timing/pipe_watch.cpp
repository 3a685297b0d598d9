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
    return {static_cast<std::uint32_t>(link.pushed()),
            static_cast<std::uint32_t>(link.popped()),
            link.arrival()};
}

} // namespace

PipeWatch::PipeWatch(const Clock& clock, const PipeParts& parts)
    : clock_(clock)
    , parts_(parts)
    , taken_(parts.requests.size()) {
    check(parts.stages.size() < 63, "a bit for each stage");
    for (const Stage& stage : parts.stages) {
        Place& place =
            places_.emplace_back(Place{.stage = &stage, .links = {}, .beside = {}, .passages = {}});
        check(stage.passages.size() <= 64, "a bit for each passage");
        for (const StagePassage& each : stage.passages)
            place.passages.push_back({each.passage});
        const StageLinks links(stage);
        const auto add = [&](const std::vector<const Link*>& more) {
            std::uint64_t bits = 0;
            for (const Link* const link : more) {
                bits |= std::uint64_t{1} << place.links.size();
                place.links.push_back({link});
            }
            return bits;
        };
        add(links.in);
        place.out = add(links.out);
        place.asked = add(links.asked);
        add(links.answered);
        check(place.links.size() <= 64, "a bit for each link");
        for (const Link* const link : stage.unit->outputs())
            if (!link->carries_requests() && std::ranges::count(links.out, link) == 0)
                place.beside.push_back(link);
        std::uint64_t bits = 0; // of all stages of its unit
        for (std::size_t i = 0; i < parts.stages.size(); ++i)
            bits |= std::uint64_t{parts.stages[i].unit == stage.unit} << i;
        stage.unit->show_calls_in(called_, bits, stage.steps.empty());
    }
    parts.arbiter.show_calls_in(called_, ArbiterBit, false);
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
    for (const AnswerSeen& answer : answers_)
        log.answers.add(answer);
    answers_.clear();
    for (std::uint64_t left = called & ~ArbiterBit; left != 0; left &= left - 1) {
        look(static_cast<std::size_t>(std::countr_zero(left)), log);
        ++cycle.stages;
    }
    if ((called & ArbiterBit) != 0 && parts_.arbiter.activity() == Activity::Busy)
        cycle.taken = note_taken(log);
    log.cycles.add(cycle);
}

std::uint32_t PipeWatch::note_taken(PipeLog& log) {
    std::uint32_t ports = 0;
    for (std::size_t port = 0; port < taken_.size(); ++port) {
        const Link& link = *parts_.requests[port];
        if (std::exchange(taken_[port], link.popped()) == link.popped()) continue;
        log.taken.add({port, seen(link)});
        ++ports;
    }
    return ports;
}

void PipeWatch::note_links(Place& place, Cycle now, StageSeen& stage, PipeLog& log) {
    std::uint64_t changed = 0, refused = 0, bit = 1;
    LinkSeen* next = log.links.room(place.links.size());
    for (WatchedLink& each : place.links) {
        const Link& link = *each.link;
        const std::uint64_t pushed = link.pushed(), popped = link.popped();
        refused |= link.refused_at() == now ? bit : 0;
        if (std::exchange(each.moves, pushed + popped) != pushed + popped) {
            next->pushed = static_cast<std::uint32_t>(pushed);
            next->popped = static_cast<std::uint32_t>(popped);
            next->arrival = link.arrival();
            ++next;
            changed |= bit;
        }
        bit <<= 1;
    }
    log.links.take_until(next);
    stage.links = changed;
    stage.refused = (refused & place.out) != 0;
    stage.request_waits = (refused & place.asked) != 0;
    stage.unit_refused = stage.refused;
    for (const Link* const link : place.beside)
        stage.unit_refused |= link->refused_at() == now;
}

void PipeWatch::note_passages(Place& place, StageSeen& stage, PipeLog& log) {
    std::uint64_t changed = 0, bit = 1;
    Passage* next = log.passages.room(place.passages.size());
    for (WatchedPassage& each : place.passages) {
        if (each.seen != *each.passage) {
            *next++ = each.seen = *each.passage;
            changed |= bit;
        }
        bit <<= 1;
    }
    log.passages.take_until(next);
    stage.passages = changed;
}

void PipeWatch::look(std::size_t place, PipeLog& log) {
    const Cycle now = clock_.now();
    Place& at = places_[place];
    const Stage& stage = *at.stage;
    StageSeen& stage_seen = *log.stages.room(1);
    stage_seen.stage = static_cast<std::uint32_t>(place);
    stage_seen.activity = stage.unit->activity();
    stage_seen.has_backlog =
        stage.input ? stage.input->arrival() <= now : stage.unit->has_backlog();
    note_links(at, now, stage_seen, log);
    note_passages(at, stage_seen, log);
    log.stages.take_until(&stage_seen + 1);
}

} // namespace ffgpu::timing
