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

Bottlenecks::Bottlenecks(const Clock& clock, CommandLedger& ledger, Parts parts)
    : clock_(clock)
    , ledger_(ledger)
    , parts_(std::move(parts)) {
    check(parts_.stages.size() < 64, "a bit for each stage");
    for (const Stage& stage : parts_.stages) {
        std::uint64_t bits = 0; // of all stages of its unit
        for (std::size_t i = 0; i < parts_.stages.size(); ++i)
            bits |= std::uint64_t{parts_.stages[i].unit == stage.unit} << i;
        stage.unit->show_work_in(working_, bits);
    }
}

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
    if (clock_.pace() == Pace::EveryCycle) return find_plainly();
    for (std::uint64_t left = working_; left != 0;) {
        const auto stage = static_cast<std::size_t>(std::bit_width(left) - 1);
        if (has_backlog(parts_.stages[stage])) return resource_of(stage);
        left ^= std::uint64_t{1} << stage;
    }
    return draining(0);
}

// Looks at idle units, too.
Resource Bottlenecks::find_plainly() const {
    for (std::size_t stage = parts_.stages.size(); stage-- > 0;)
        if (has_backlog(parts_.stages[stage])) return resource_of(stage);
    return draining(0);
}

Resource Bottlenecks::draining(std::size_t stage) const {
    if (stage == parts_.stages.size() || working_ >> stage == 0) return Resource::Links;
    return resource_of(stage + static_cast<std::size_t>(std::countr_zero(working_ >> stage)));
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
