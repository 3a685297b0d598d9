#include "model/timing/clock.h"

#include "model/base/check.h"
#include "model/timing/unit.h"

#include <algorithm>
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
    check(units_.size() < 63, "a bit for each unit");
    units_.push_back(&unit);
    due_.push_back(Never);
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
    if (!must_wait_()) return false;
    pause();
    return true;
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
        const Cycle due = next_due();
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

Cycle Clock::next_due() {
    if (due_next_ != 0) return now_ + 1;
    soonest_ = *std::min_element(due_.begin(), due_.end());
    return soonest_;
}

// Of this cycle, a bit each. They are due no more.
std::uint64_t Clock::take_due() {
    std::uint64_t due = std::exchange(due_next_, 0);
    if (pace_ == Pace::EveryCycle) due = (std::uint64_t{1} << units_.size()) - 1;
    if (soonest_ > now_) return due;
    soonest_ = Never;
    for (std::size_t i = 0; i < due_.size(); ++i) {
        if (due_[i] <= now_) {
            due |= std::uint64_t{1} << i;
            due_[i] = Never;
        }
        soonest_ = std::min(soonest_, due_[i]);
    }
    return due;
}

// Who is due is settled before the first unit runs: what wakes a unit in this cycle wakes it for
// the next.
void Clock::walk() {
    for (std::uint64_t due = take_due(); due != 0; due &= due - 1)
        units_[static_cast<std::size_t>(std::countr_zero(due))]->run_cycle();
    if (on_walked_) on_walked_();
}

} // namespace ffgpu::timing
