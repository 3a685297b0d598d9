#include "model/timing/bottlenecks.h"

#include "model/base/check.h"

#include <algorithm>
#include <bit>
#include <string>
#include <utility>

namespace ffgpu::timing {

BottleneckStatistics::BottleneckStatistics() {
    for (std::size_t i = 0; i < Resources; ++i)
        cycles_[i] = &add("bottleneck_" + std::string(ResourceNames[i]) + "_cycles",
                          "cycles",
                          "in which the machine waited for it");
}

Bottlenecks::Bottlenecks(const Clock& clock, Parts parts)
    : clock_(clock)
    , parts_(std::move(parts)) {
    check(parts_.stages.size() < 64, "a bit for each stage");
    for (const Stage& stage : parts_.stages)
        places_.push_back({.stage = stage, .from = {}, .to = {}, .now = {}, .next = {}});
    for (std::size_t i = 0; i < places_.size(); ++i) {
        connect(i);
        std::uint64_t bits = 0; // of all stages of its unit
        for (std::size_t j = 0; j < places_.size(); ++j)
            bits |= std::uint64_t{places_[j].stage.unit == places_[i].stage.unit} << j;
        places_[i].stage.unit->show_calls_in(called_, bits);
        heads_.push_back(&places_[i].now.path);
    }
    paths_.restart(0);
}

std::size_t Bottlenecks::stage_of(const Unit* unit, const Link* link, bool consumes) const {
    for (std::size_t i = 0; i < places_.size(); ++i) {
        const Stage& stage = places_[i].stage;
        const Link* const own = consumes ? stage.input : stage.output;
        if (stage.unit == unit && (!own || own == link)) return i;
    }
    return None;
}

// The memory and its caches are no stages.
void Bottlenecks::connect(std::size_t number) {
    Place& place = places_[number];
    for (const Link* const link : place.stage.unit->inputs()) {
        if (place.stage.input && place.stage.input != link) continue;
        const std::size_t from = stage_of(link->producer(), link, false);
        if (from != None) place.from.push_back({link, from});
    }
    for (const Link* const link : place.stage.unit->outputs()) {
        if (place.stage.output && place.stage.output != link) continue;
        const std::size_t to = stage_of(link->consumer(), link, true);
        if (to != None) place.to.push_back({link, to});
    }
}

// --- Each cycle --------------------------------------------------------------------------------

// All look at the paths as they were before the cycle.
void Bottlenecks::end_cycle() {
    const std::uint64_t looked = std::exchange(called_, 0) | on_memory_;
    for (std::uint64_t left = looked; left != 0; left &= left - 1)
        look(static_cast<std::size_t>(std::countr_zero(left)));
    for (std::uint64_t left = looked; left != 0; left &= left - 1) {
        Place& place = places_[static_cast<std::size_t>(std::countr_zero(left))];
        place.now = place.next;
    }
    paths_.collect(heads_);
}

void Bottlenecks::look(std::size_t number) {
    Place& place = places_[number];
    const Cycle before = clock_.now() - 1;
    const Activity activity = place.stage.unit->activity();
    const Neighbor* const refuser = refused(place);
    State& next = place.next = place.now;
    const std::uint64_t bit = std::uint64_t{1} << number;
    on_memory_ &= ~bit;
    if (is_stalled_on_memory(place)) {
        on_memory_ |= bit;
        wait_for_memory(place, next);
    } else if (refuser && activity != Activity::Idle) {
        if (next.mode != Mode::Follows || next.followed != refuser->stage)
            next.path = path_of(number, before);
        next.mode = Mode::Follows;
        next.followed = refuser->stage;
    } else if (activity == Activity::StalledOutput) {
        if (next.mode != Mode::Drains) next.path = path_of(number, before);
        next.mode = Mode::Drains;
    } else if (activity == Activity::Busy && acts(place)) {
        work(place, next);
    } else {
        if (next.mode != Mode::Idle) {
            next.path = path_of(number, before);
            next.active = before;
        }
        next.mode = Mode::Idle;
    }
    next.backlog = has_backlog(place.stage);
}

void Bottlenecks::work(Place& place, State& next) {
    const auto number = static_cast<std::size_t>(&place - places_.data());
    const Neighbor* const sender = arrived(place);
    const bool waited = place.now.mode == Mode::Idle || place.now.mode == Mode::Drains;
    const bool comes_back = sender && sender->stage > number;
    if (sender && (comes_back ? waited : !place.now.backlog))
        next.path = path_from(*sender);
    else
        next.path = path_of(number, clock_.now() - 1);
    next.mode = Mode::Works;
    next.resource = place.stage.resource;
}

// Of a unit with two ways: this one did something in the cycle.
bool Bottlenecks::acts(const Place& place) const {
    if (!place.stage.input) return true;
    return arrived(place) || place.stage.output->pushed_at() == clock_.now() ||
           has_backlog(place.stage);
}

// Something was taken, or has come and is worked on; what comes back along the pipe goes first.
const Bottlenecks::Neighbor* Bottlenecks::arrived(const Place& place) const {
    const Neighbor* found = nullptr;
    for (const Neighbor& sender : place.from)
        if (sender.link->popped_at() == clock_.now() || sender.link->arrival() == clock_.now())
            if (!found || sender.stage > found->stage) found = &sender;
    return found;
}

const Bottlenecks::Neighbor* Bottlenecks::refused(const Place& place) const {
    for (const Neighbor& receiver : place.to)
        if (receiver.link->refused_at() == clock_.now()) return &receiver;
    return nullptr;
}

// --- Paths -------------------------------------------------------------------------------------

// Up to the end of cycle `end`, as the stage was before this cycle. Nobody follows in circles but
// for a moment: then a path ends here.
WaitPaths::Path Bottlenecks::path_of(std::size_t number, Cycle end, std::size_t steps) {
    State& state = places_[number].now;
    if (steps > places_.size()) return paths_.extend(state.path, Resource::Links, end);
    switch (state.mode) {
    case Mode::Works:
        state.path = paths_.extend(state.path, state.resource, end);
        break;
    case Mode::Follows:
        return paths_.share(path_of(state.followed, end, steps + 1));
    case Mode::Drains:
        return paths_.share(path_of_last(number, end, steps + 1));
    case Mode::Idle:
        break;
    }
    return state.path;
}

// Of the stage behind that was the last to do something.
WaitPaths::Path Bottlenecks::path_of_last(std::size_t but, Cycle end, std::size_t steps) {
    std::size_t last = None;
    for (std::size_t i = but + 1; i < places_.size(); ++i)
        if (last == None || active_at(places_[i]) >= active_at(places_[last])) last = i;
    if (last == None) return paths_.extend(places_[but].now.path, Resource::Links, end);
    return paths_.extend(paths_.share(path_of(last, end, steps)), Resource::Links, end);
}

// What arrives in this cycle was sent when its way began.
WaitPaths::Path Bottlenecks::path_from(const Neighbor& sender) {
    const Cycle now = clock_.now();
    const Cycle sent = now > sender.link->latency() ? now - sender.link->latency() : 0;
    return paths_.extend(
        paths_.cut(path_of(sender.stage, now - 1), sent), Resource::Links, now - 1);
}

// --- The memory --------------------------------------------------------------------------------

void Bottlenecks::wait_for_memory(Place& place, State& next) {
    const Resource resource = memory_resource(place.stage);
    if (next.mode == Mode::Works && next.resource == resource) return;
    next.path = path_of(static_cast<std::size_t>(&place - places_.data()), clock_.now() - 1);
    next.mode = Mode::Works;
    next.resource = resource;
}

// The unit's requests are held up there, or on their way.
Resource Bottlenecks::memory_resource(const Stage& stage) const {
    if (stage.resource == Resource::Texture && parts_.second_level) {
        const Activity activity = parts_.second_level->activity();
        if (activity == Activity::Busy || activity == Activity::Idle) return Resource::TexelL2;
    }
    const bool writes = stage.unit->activity() == Activity::StalledRequests;
    const bool served = std::any_of(stage.clients.begin(), stage.clients.end(), [&](Client client) {
        return parts_.memory.serves(client, false) ||
               (writes && parts_.memory.serves(client, true));
    });
    return served || parts_.arbiter.has_backlog() ? Resource::MemoryBandwidth
                                                  : Resource::MemoryLatency;
}

std::vector<WaitPaths::Run> Bottlenecks::end_frame() {
    std::size_t last = 0;
    for (std::size_t i = 1; i < places_.size(); ++i)
        if (active_at(places_[i]) > active_at(places_[last])) last = i;
    const WaitPaths::Path path =
        paths_.extend(path_of(last, clock_.now()), Resource::Links, clock_.now());
    const std::vector<WaitPaths::Run> runs = paths_.runs(path);
    Cycle begin = frame_begin_;
    for (const WaitPaths::Run& run : runs)
        statistics_.waited(run.resource, run.end - std::exchange(begin, run.end));
    check(begin == clock_.now(), "a frame's path goes from its begin to its end");
    frame_begin_ = clock_.now();
    paths_.restart(clock_.now());
    for (Place& place : places_)
        place.now.path = 0;
    return runs;
}

} // namespace ffgpu::timing
