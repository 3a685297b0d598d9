// Bottlenecks: what the machine waited for, in each cycle one resource.
//
// A machine's pace is that of the unit before which work queues up while nothing queues up behind
// it. So the stages of the pipe are looked at from the last to the first: the first one found with
// work left over at its input is the end of the chain of stalls, since all before it stall on it
// and all behind it wait for it. Where no work is left over anywhere the pipe fills or drains: then
// it waits for the first stage that has anything to do. What that stage does in the cycle tells the
// resource: itself where it works, the memory where it waits for data or for a place to ask for
// them.
//
// Nothing changes between two cycles in which a unit is due: the cycles between are counted at
// once. A unit is idle where nothing is at its input: the stages of idle units are left out.

#pragma once

#include "model/timing/command_ledger.h"
#include "model/timing/memory_module.h"
#include "model/timing/memory_statistics.h"
#include "model/timing/resource.h"
#include "model/timing/unit.h"

#include <array>
#include <vector>

namespace ffgpu::timing {

// A unit's place in the pipe; a unit with two ways through it has two.
struct Stage {
    Resource resource;
    Unit* unit;
    std::vector<Client> clients; // as whom it asks the memory
    const Link* input = nullptr; // by which work comes; null: Unit::has_backlog() tells
};

class BottleneckStatistics : public NamedStatistics {
public:
    BottleneckStatistics();
    void waited(Resource resource, Cycle cycles) {
        *cycles_[static_cast<std::size_t>(resource)] += cycles;
    }

private:
    std::array<Counter*, Resources> cycles_;
};

class Bottlenecks {
public:
    struct Parts {
        std::vector<Stage> stages; // in the order of the pipe
        const Unit& arbiter;
        const MemoryModule& memory;
        const Unit* second_level; // of the texel caches; null: none
    };

    Bottlenecks(const Clock& clock, CommandLedger& ledger, Parts parts);

    // At the end of each cycle in which a unit was due.
    void end_cycle();
    // At the end of a frame: all cycles up to now are counted.
    void settle() { count_until(clock_.now()); }
    const BottleneckStatistics& statistics() const { return statistics_; }

private:
    void count_until(Cycle end);
    Resource find() const;
    Resource find_plainly() const;
    Resource resource_of(std::size_t stage) const;
    // Behind `stage`, the first that is not idle.
    Resource draining(std::size_t stage) const;
    Resource memory(const Stage& stage) const;
    bool has_backlog(const Stage& stage) const {
        return stage.input ? stage.input->arrival() <= clock_.now() : stage.unit->has_backlog();
    }

    const Clock& clock_;
    CommandLedger& ledger_;
    const Parts parts_;
    BottleneckStatistics statistics_;
    Resource last_ = Resource::Host; // of all cycles since counted_
    Cycle counted_ = 0;
    std::uint64_t working_ = 0; // stages whose units are not idle, a bit each
};

} // namespace ffgpu::timing
