#include "model/timing/pipe_watch.h"

#include "model/base/check.h"
#include "model/timing/link.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace ffgpu::timing {
namespace {

constexpr std::uint64_t ArbiterBit = std::uint64_t{1} << 63;
constexpr std::size_t StagesInLog = 1 << 11, CyclesInLog = 1 << 11; // before it is full

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
        Place& place = places_.emplace_back(Place{.stage = &stage, .ways = StageLinks(stage)});
        const StageLinks& ways = place.ways;
        for (const auto* const links : {&ways.in, &ways.out, &ways.asked, &ways.answered})
            for (const Link* const link : *links)
                place.links.push_back({link});
        for (const StagePassage& each : stage.passages)
            place.passages.push_back({each.passage});
        check(place.links.size() <= 64, "a bit for each link");
        check(place.passages.size() <= 64, "a bit for each passage");
        for (const Link* const link : stage.unit->outputs())
            if (!link->carries_requests() && std::ranges::count(ways.out, link) == 0)
                place.beside.push_back(link);
        links_ += place.links.size();
        passages_ += place.passages.size();
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

// A cycle takes no more than a part of what was made room for behind where it is full.
void PipeWatch::write_to(PipeLog& log) {
    log_ = &log;
    next_ = {log.cycles.room(CyclesInLog + 1),
             log.stages.room(StagesInLog + places_.size()),
             log.links.room(2 * StagesInLog + links_),
             log.passages.room(StagesInLog + passages_)};
    full_ = {next_.cycles + CyclesInLog,
             next_.stages + StagesInLog,
             next_.links + 2 * StagesInLog,
             next_.passages + StagesInLog};
}

void PipeWatch::finish_log() {
    log_->cycles.take_until(next_.cycles);
    log_->stages.take_until(next_.stages);
    log_->links.take_until(next_.links);
    log_->passages.take_until(next_.passages);
}

void PipeWatch::end_cycle(std::size_t charged) {
    const std::uint64_t called = std::exchange(called_, 0);
    if (called == 0 && answers_.empty()) return;
    CycleSeen& cycle = *next_.cycles; // Field by field, as look().
    cycle.now = clock_.now();
    cycle.charged = charged;
    cycle.answers = static_cast<std::uint32_t>(answers_.size());
    for (const AnswerSeen& answer : answers_)
        log_->answers.add(answer);
    answers_.clear();
    const StageSeen* const before = next_.stages;
    note_stages(called & ~ArbiterBit);
    cycle.stages = static_cast<std::uint32_t>(next_.stages - before);
    const bool takes = (called & ArbiterBit) != 0 && parts_.arbiter.activity() == Activity::Busy;
    cycle.taken = takes ? note_taken() : 0;
    ++next_.cycles;
}

std::uint32_t PipeWatch::note_taken() {
    std::uint32_t ports = 0;
    for (std::size_t port = 0; port < taken_.size(); ++port) {
        const Link& link = *parts_.requests[port];
        if (std::exchange(taken_[port], link.popped()) == link.popped()) continue;
        log_->taken.add({port, seen(link)});
        ++ports;
    }
    return ports;
}

void PipeWatch::note_stages(std::uint64_t called) {
    const Cycle now = clock_.now();
    Room next = next_;
    for (std::uint64_t left = called; left != 0; left &= left - 1) {
        const auto place = static_cast<std::uint32_t>(std::countr_zero(left));
        look(places_[place], place, now, next);
    }
    next_ = next;
}

std::uint64_t PipeWatch::note_links(Place& place, Room& room) {
    std::uint64_t changed = 0, bit = 1;
    LinkSeen* next = room.links;
    for (WatchedLink& each : place.links) {
        const Link& link = *each.link;
        const std::uint64_t moves = link.pushed() + link.popped();
        if (moves != each.moves) {
            each.moves = moves;
            *next++ = seen(link);
            changed |= bit;
        }
        bit <<= 1;
    }
    room.links = next;
    return changed;
}

std::uint64_t PipeWatch::note_passages(Place& place, Room& room) {
    std::uint64_t changed = 0, bit = 1;
    Passage* next = room.passages;
    for (WatchedPassage& each : place.passages) {
        if (const std::uint32_t moves = each.passage->moves(); moves != each.moves) {
            each.moves = moves;
            *next++ = *each.passage;
            changed |= bit;
        }
        bit <<= 1;
    }
    room.passages = next;
    return changed;
}

// Field by field, in its place in the log: what was put together elsewhere would have to wait for
// its parts to be copied.
void PipeWatch::look(Place& at, std::uint32_t place, Cycle now, Room& room) {
    const auto refused = [now](const Link* link) { return link->refused_at() == now; };
    const std::uint64_t links = note_links(at, room), passages = note_passages(at, room);
    const bool request_waits = std::ranges::any_of(at.ways.asked, refused);
    const bool waited = std::exchange(at.request_waits, request_waits);
    StageSeen& seen = *room.stages;
    const Stage& stage = *at.stage;
    if (stage.steps.empty()) {
        const Unit& unit = *stage.unit;
        seen.activity = unit.activity();
        seen.has_backlog = stage.input ? stage.input->arrival() <= now : unit.has_backlog();
        seen.refused = std::ranges::any_of(at.ways.out, refused);
        seen.unit_refused = seen.refused || std::ranges::any_of(at.beside, refused);
    } else if ((links | passages) == 0 && !request_waits && !waited) {
        return;
    }
    seen.links = links;
    seen.passages = passages;
    seen.stage = place;
    seen.request_waits = request_waits;
    ++room.stages;
}

} // namespace ffgpu::timing
