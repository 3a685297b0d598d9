// Clock: one rising edge a cycle for all units, and the cycle's number.
//
// The edge is one SystemC event that Clock fires once a nanosecond; a unit that sleeps does not see
// it. Before a cycle begins the clock asks whether the command processor waits for the host: then
// the simulation pauses with time standing still, so that the host's pace is never part of a
// result.

#pragma once

#include <cstdint>
#include <functional>
#include <systemc>

namespace ffgpu::timing {

using Cycle = std::uint64_t;

class Clock : public sc_core::sc_module {
public:
    // `must_wait`: true while the machine has to wait for the host (the simulation then pauses).
    Clock(sc_core::sc_module_name name, std::function<bool()> must_wait)
        : sc_module(name)
        , must_wait_(std::move(must_wait)) {
        SC_HAS_PROCESS(Clock);
        SC_METHOD(on_tick);
    }

    Cycle now() const { return now_; }
    const sc_core::sc_event& edge() const { return edge_; }

private:
    void on_tick() {
        if (must_wait_()) {
            sc_core::sc_pause();
            next_trigger(resume_);
            resume_.notify(sc_core::SC_ZERO_TIME);
            return;
        }
        ++now_;
        edge_.notify();
        next_trigger(1, sc_core::SC_NS);
    }

    std::function<bool()> must_wait_;
    sc_core::sc_event edge_;
    sc_core::sc_event resume_;
    Cycle now_ = 0;
};

} // namespace ffgpu::timing
