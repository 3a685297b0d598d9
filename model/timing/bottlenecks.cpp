#include "model/timing/bottlenecks.h"

#include <algorithm>
#include <string>
#include <utility>

namespace ffgpu::timing {

BottleneckStatistics::BottleneckStatistics() {
    for (std::size_t i = 0; i < Resources; ++i)
        cycles_[i] = &add("bottleneck_" + std::string(ResourceNames[i]) + "_cycles",
                          "cycles",
                          "in which the machine waited for it");
}

Bottlenecks::Bottlenecks(const Clock& clock, CommandLedger& ledger, Parts parts)
    : clock_(clock)
    , ledger_(ledger)
    , parts_(std::move(parts)) {}

void Bottlenecks::end_cycle() {
    const Resource found = find();
    if (found != last_) {
        count_until(clock_.now() - 1);
        last_ = found;
    }
    if (!ledger_.charges_at(clock_.now())) return;
    count_until(clock_.now());
    ledger_.explain_charge(clock_.now());
}

void Bottlenecks::count_until(Cycle end) {
    if (end <= counted_) return;
    statistics_.waited(last_, end - counted_);
    ledger_.waited(last_, end - counted_);
    counted_ = end;
}

Resource Bottlenecks::find() const {
    const std::vector<Stage>& stages = parts_.stages;
    const bool looks_at_idle = clock_.pace() == Pace::EveryCycle;
    for (std::size_t i = stages.size(); i-- > 0;) {
        // A unit is idle where nothing is at its input; the plainest pace looks all the same.
        if (stages[i].unit->activity() == Activity::Idle && !looks_at_idle) continue;
        if (has_backlog(stages[i])) return resource_of(i);
    }
    return draining(0);
}

Resource Bottlenecks::draining(std::size_t stage) const {
    for (; stage < parts_.stages.size(); ++stage)
        if (parts_.stages[stage].unit->activity() != Activity::Idle) return resource_of(stage);
    return Resource::Links;
}

Resource Bottlenecks::resource_of(std::size_t stage) const {
    const Stage& waiting = parts_.stages[stage];
    switch (waiting.unit->activity()) {
    case Activity::StalledMemory:
    case Activity::StalledRequests:
        if (waiting.resource == Resource::Texture && parts_.second_level) {
            const Activity activity = parts_.second_level->activity();
            if (activity == Activity::Busy || activity == Activity::Idle) return Resource::TexelL2;
        }
        return memory(waiting);
    case Activity::StalledOutput:
        return draining(stage + 1); // All behind it took what they could: it is on its way.
    default:
        return waiting.resource;
    }
}

// The unit's requests are held up there, or on their way.
Resource Bottlenecks::memory(const Stage& stage) const {
    const bool writes = stage.unit->activity() == Activity::StalledRequests;
    const bool served = std::any_of(stage.clients.begin(), stage.clients.end(), [&](Client client) {
        return parts_.memory.serves(client, false) ||
               (writes && parts_.memory.serves(client, true));
    });
    return served || parts_.arbiter.has_backlog() ? Resource::MemoryBandwidth
                                                  : Resource::MemoryLatency;
}

} // namespace ffgpu::timing
