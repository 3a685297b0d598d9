#include "model/timing/clock.h"

#include "model/base/check.h"
#include "model/timing/unit.h"

#include <bit>
#include <utility>

namespace ffgpu::timing {
namespace {

constexpr Cycle Quantum = 4096; // that a decoupled clock runs ahead of SystemC's time

} // namespace

Clock::Clock(sc_core::sc_module_name name, std::function<bool()> must_wait, Pace pace)
    : sc_module(name)
    , must_wait_(std::move(must_wait))
    , pace_(pace) {
    SC_HAS_PROCESS(Clock);
    SC_METHOD(on_tick);
}

std::size_t Clock::attach(Unit& unit) const {
    check(units_.size() < Calendar::MostUnits, "a bit for each unit");
    units_.push_back(&unit);
    wake(units_.size() - 1, now_ + 1);
    return units_.size() - 1;
}

void Clock::on_tick() {
    const bool runs = pace_ == Pace::Decoupled ? run_ahead() : run_cycle();
    if (!runs) return;
    next_trigger(static_cast<double>(now_ - systemc_now_), sc_core::SC_NS);
    systemc_now_ = now_;
}

bool Clock::paused() {
    if (!asks_ && now_ < ask_from_) return false;
    asks_ = must_wait_();
    if (asks_) pause();
    return asks_;
}

void Clock::pause() {
    sc_core::sc_pause();
    next_trigger(resume_);
    resume_.notify(sc_core::SC_ZERO_TIME);
}

bool Clock::run_cycle() {
    if (paused()) return false;
    ++now_;
    walk();
    edge_.notify();
    return true;
}

bool Clock::run_ahead() {
    const Cycle end = now_ + Quantum;
    while (now_ < end) {
        if (paused()) return false;
        const Cycle due = calendar_.next(now_);
        if (due == Never) {
            is_stuck_ = true;
            pause();
            return false;
        }
        now_ = due;
        walk();
    }
    return true;
}

// Who is due is settled before the first unit runs: what wakes a unit in this cycle wakes it for
// the next.
void Clock::walk() {
    std::uint64_t due = calendar_.take(now_);
    if (pace_ == Pace::EveryCycle) due = (std::uint64_t{1} << units_.size()) - 1;
    Unit* const* const units = units_.data();
    for (; due != 0; due &= due - 1)
        units[static_cast<std::size_t>(std::countr_zero(due))]->run_cycle();
    if (on_walked_) on_walked_();
}

} // namespace ffgpu::timing
