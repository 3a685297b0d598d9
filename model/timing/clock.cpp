#include "model/timing/clock.h"

#include "model/base/check.h"
#include "model/timing/unit.h"

#include <algorithm>

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
    units_.push_back(&unit);
    due_.push_back(now_ + 1);
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
    sc_core::sc_pause();
    next_trigger(resume_);
    resume_.notify(sc_core::SC_ZERO_TIME);
    return true;
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
        const Cycle due = *std::min_element(due_.begin(), due_.end());
        check(due != Never, "no unit of the timed machine will ever work again");
        now_ = std::max(due, now_ + 1);
        walk();
    }
    return true;
}

// Who is due is settled before the first unit runs: what wakes a unit in this cycle wakes it for
// the next.
void Clock::walk() {
    walked_.clear();
    for (std::size_t i = 0; i < units_.size(); ++i) {
        if (due_[i] > now_ && pace_ != Pace::EveryCycle) continue;
        due_[i] = Never;
        walked_.push_back(units_[i]);
    }
    for (Unit* const unit : walked_)
        unit->run_cycle();
}

} // namespace ffgpu::timing
