// Clock: the cycle's number, and the one SystemC method that walks the units in it.
//
// A unit is stepped in the cycles that it is due in (unit.h). Before a cycle begins the clock asks
// whether the machine waits for the host, for commands or for quads: then the simulation pauses
// with time standing still, so that the host's pace is never part of a result.

#pragma once

#include "model/timing/calendar.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <systemc>
#include <utility>
#include <vector>

namespace ffgpu::timing {

class Unit;

// How the clock goes through time. No figure depends on it.
enum class Pace {
    EveryCycle, // each unit in each cycle, whether it is due or not, and the plain form of all that
                // has a fast one: what the others must equal
    Lockstep,   // each cycle, the units that are due; SystemC's time goes along, the edge is fired
    Decoupled,  // from one cycle in which a unit is due to the next; SystemC's time follows behind
};

struct Evaluation {
    Evaluation(std::uint32_t seed = 0, Pace how = Pace::Decoupled)
        : order(seed)
        , pace(how) {}

    std::uint32_t order; // a seed by which the units are shuffled; 0: in the order of the pipe
    Pace pace;
};

class Clock : public sc_core::sc_module {
public:
    // `must_wait`: true while the machine has to wait for the host (the simulation then pauses).
    Clock(sc_core::sc_module_name name,
          std::function<bool()> must_wait,
          Pace pace = Pace::Lockstep);

    // Called at the end of each cycle in which a unit was due.
    void set_on_walked(std::function<void()> on_walked) { on_walked_ = std::move(on_walked); }

    // Before cycle `at` it need not be asked again whether the machine has to wait, unless somebody
    // calls ask(). Else it is asked before each cycle that is walked.
    void ask_from(Cycle at) { ask_from_ = at; }
    void ask() const { asks_ = true; }

    // Decoupled only where every process that takes part is a unit of this clock.
    void set_pace(Pace pace) { pace_ = pace; }
    Pace pace() const { return pace_; }

    Cycle now() const { return now_; }
    // No unit will ever be due again, and the host is not waited for: the simulation paused.
    bool is_stuck() const { return is_stuck_; }
    // For processes that are not units: once a cycle, after the units. Not fired when decoupled.
    const sc_core::sc_event& edge() const { return edge_; }

    // The units, in the order in which they are evaluated; returns the unit's place. Units know
    // the clock as one that they cannot change: when they are due is not its time.
    std::size_t attach(Unit& unit) const;
    [[gnu::always_inline]] void wake(std::size_t place, Cycle at) const {
        calendar_.add(place, std::max(at, now_ + 1), now_);
    }

private:
    void on_tick();
    // False where the simulation pauses before it.
    bool run_cycle();
    bool run_ahead();
    bool paused();
    void pause();
    void walk();

    std::function<bool()> must_wait_;
    std::function<void()> on_walked_;
    Pace pace_;
    sc_core::sc_event edge_;
    sc_core::sc_event resume_;
    Cycle now_ = 0;
    Cycle ask_from_ = 0;
    mutable bool asks_ = true;
    Cycle systemc_now_ = 0; // the cycle that SystemC's time stands at
    mutable std::vector<Unit*> units_;
    mutable Calendar calendar_;
    bool is_stuck_ = false;
};

} // namespace ffgpu::timing
