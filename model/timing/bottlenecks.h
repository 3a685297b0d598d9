// Bottlenecks: what the machine waited for, in each cycle one resource: the critical path.
//
// Of two things that a unit waits for, the one that comes last decides when it goes on. So each
// stage of the pipe has a path: what was waited for, cycle after cycle, until it was where it is.
//   - While it works, it makes its path longer by its own resource; while it waits for data, by the
//     memory.
//   - What comes to a stage that had no work left over was waited for: it goes on along the path of
//     the stage that sent it.
//   - A stage that is refused a place goes on along the path of the stage that frees one.
// Work that was left over, and places that were free, cost nothing, and leave no trace: whether a
// cycle of a stage counted is known only later. The path that ends last, at the end of a frame, is
// the frame's.

#pragma once

#include "model/timing/memory_module.h"
#include "model/timing/memory_statistics.h"
#include "model/timing/resource.h"
#include "model/timing/unit.h"
#include "model/timing/wait_paths.h"

#include <array>
#include <vector>

namespace ffgpu::timing {

// A unit's place in the pipe. A unit with two ways through it has two, each with its links.
struct Stage {
    Resource resource;
    Unit* unit;
    std::vector<Client> clients; // as whom it asks the memory
    const Link* input = nullptr; // null: all of the unit's
    const Link* output = nullptr;
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

    // Links are connected.
    Bottlenecks(const Clock& clock, Parts parts);

    // At the end of each cycle in which a unit was due.
    void end_cycle();
    // A frame ended with this cycle: its path.
    std::vector<WaitPaths::Run> end_frame();
    const BottleneckStatistics& statistics() const { return statistics_; }

private:
    static constexpr std::size_t None = ~std::size_t{0};

    // The stage at the other end of a link.
    struct Neighbor {
        const Link* link;
        std::size_t stage;
    };
    enum class Mode : std::uint8_t {
        Idle,
        Works,   // or waits for the memory
        Follows, // a stage that refuses it a place
        Drains,  // waits until what is behind it is done
    };
    struct State {
        Mode mode = Mode::Idle;
        Resource resource = Resource::Links; // Works
        std::size_t followed = 0;            // Follows
        WaitPaths::Path path = 0;            // up to the cycle before the mode began, or beyond
        bool backlog = false;                // Work was left over.
        Cycle active = 0;                    // Idle: the last cycle in which it was not
    };
    struct Place {
        Stage stage;
        std::vector<Neighbor> from, to;
        State now, next;
    };

    void connect(std::size_t number);
    std::size_t stage_of(const Unit* unit, const Link* link, bool consumes) const;
    void look(std::size_t number);
    void work(Place& place, State& next);
    const Neighbor* arrived(const Place& place) const;
    const Neighbor* refused(const Place& place) const;
    bool acts(const Place& place) const;
    WaitPaths::Path path_of(std::size_t number, Cycle end, std::size_t steps = 0);
    WaitPaths::Path path_of_last(std::size_t but, Cycle end, std::size_t steps);
    WaitPaths::Path path_from(const Neighbor& sender);
    void wait_for_memory(Place& place, State& next);
    Resource memory_resource(const Stage& stage) const;
    static bool is_stalled_on_memory(const Place& place) {
        const Activity activity = place.stage.unit->activity();
        return activity == Activity::StalledMemory || activity == Activity::StalledRequests;
    }
    Cycle active_at(const Place& place) const {
        return place.now.mode == Mode::Idle ? place.now.active : clock_.now();
    }
    bool has_backlog(const Stage& stage) const {
        return stage.input ? stage.input->arrival() <= clock_.now() : stage.unit->has_backlog();
    }

    const Clock& clock_;
    const Parts parts_;
    BottleneckStatistics statistics_;
    WaitPaths paths_;
    std::vector<Place> places_;
    std::vector<WaitPaths::Path*> heads_;
    // Stages, a bit each: whose units were called in this cycle; that wait for the memory.
    std::uint64_t called_ = 0, on_memory_ = 0;
    Cycle frame_begin_ = 0; // The cycle before it.
};

} // namespace ffgpu::timing
