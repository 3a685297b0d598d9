// Unit: a clocked hardware unit. step() does one cycle's work and says what the cycle was; the base
// keeps the account and puts a unit that cannot work to sleep until a channel wakes it.

#pragma once

#include "model/timing/account.h"
#include "model/timing/clock.h"

#include <systemc>

namespace ffgpu::timing {

class Unit : public sc_core::sc_module {
public:
    const Account& account() const { return account_; }

    // Accounts the cycles slept through up to and including the current one.
    void settle() {
        const Cycle now = clock_.now();
        if (now > accounted_) account_.add(last_, now - accounted_);
        accounted_ = now;
    }

    // A channel's other end did something: the unit runs again from the next cycle on.
    void wake() {
        if (asleep_) wake_.notify(sc_core::SC_ZERO_TIME);
    }

    // Makes the unit a method of the clock's edge. Units are called in the order in which they were
    // attached; no result depends on it.
    void attach() {
        sc_core::sc_spawn_options options;
        options.spawn_method();
        options.dont_initialize();
        options.set_sensitivity(&clock_.edge());
        sc_core::sc_spawn([this] { on_edge(); }, sc_core::sc_gen_unique_name("on_edge"), &options);
    }

protected:
    Unit(sc_core::sc_module_name name, const Clock& clock)
        : sc_module(name)
        , clock_(clock)
        , account_(static_cast<const char*>(name)) {}

    // One cycle. Reads channels as they stood when the cycle began.
    virtual Activity step() = 0;

    // True where nothing can happen before a channel or the memory wakes the unit: its inputs hold
    // nothing at all, or its outputs are full for good. A unit with work in flight says false.
    virtual bool may_sleep() const = 0;

    Cycle now() const { return clock_.now(); }

private:
    void on_edge() {
        if (asleep_) { // Woken during a cycle; the next edge is the first to work in.
            settle();
            asleep_ = false;
            return;
        }
        settle_before_step();
        last_ = step();
        account_.add(last_, 1);
        accounted_ = clock_.now();
        if (last_ != Activity::Busy && may_sleep()) {
            asleep_ = true;
            sc_core::next_trigger(wake_);
        }
    }

    void settle_before_step() {
        const Cycle before = clock_.now() - 1;
        if (before > accounted_) account_.add(last_, before - accounted_);
        accounted_ = before;
    }

    const Clock& clock_;
    Account account_;
    sc_core::sc_event wake_;
    Activity last_ = Activity::Idle;
    Cycle accounted_ = 0;
    bool asleep_ = false;
};

} // namespace ffgpu::timing
