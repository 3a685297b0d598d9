// BenchClock: a clock for single units and caches, run cycle by cycle by the test.

#pragma once

#include "model/timing/clock.h"
#include "model/timing/simulation_context.h"

#include <functional>

namespace ffgpu::timing {

class BenchClock {
    SimulationContext context_;
    SimulationContext::Scope scope_{context_};
    std::function<bool()> done_ = [] { return true; };

public:
    Clock clock{"clock", [this] { return done_(); }};

    // Runs until `done` is true before a cycle.
    void run_until(std::function<bool()> done) {
        done_ = std::move(done);
        sc_core::sc_start();
    }
    void run(Cycle cycles) {
        run_until([this, end = clock.now() + cycles] { return clock.now() >= end; });
    }
};

} // namespace ffgpu::timing
