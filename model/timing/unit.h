// Unit: a clocked hardware unit. step() does one cycle's work and says what the cycle was; the base
// keeps the account, and has step() called only in the cycles in which the unit is due.
//
// A unit is due in the cycle after one in which it was busy, else not, unless it says otherwise
// (next_work). Whatever it says, it is due again
//   - when an item of a channel of which it is the consumer arrives,
//   - one cycle after a place came free in a channel of which it is the producer and in which
//     can_push() refused it,
//   - when somebody calls wake().
// A cycle may be left out if step() would have changed nothing in it and said what it said last, or
// what a busy one said that it comes to rest as (rest_as); one that is called too often does no
// harm. Clock's Pace::EveryCycle calls all of them: a unit that sleeps too long shows as a figure
// that differs from it (tests/timing/pace_test.cpp).

#pragma once

#include "model/timing/account.h"
#include "model/timing/activity_observer.h"
#include "model/timing/clock.h"
#include "model/timing/link.h"

#include <algorithm>
#include <string>
#include <systemc>
#include <vector>

namespace ffgpu::timing {

class Unit : public sc_core::sc_module {
public:
    const Account& account() const { return account_; }
    // What the last cycle was.
    Activity activity() const { return rests_from_ > now() ? Activity::Busy : last_; }
    // What it has inside, on one line, for a report of a machine that is stuck.
    virtual std::string state() const { return {}; }
    // It waits for somebody who is no unit.
    virtual bool waits_outside() const { return false; }
    // The first of the cycles that were all as the last one.
    Cycle since() const { return since_; }
    const std::vector<const Link*>& inputs() const { return inputs_; }
    const std::vector<const Link*>& outputs() const { return outputs_; }

    // At the end of a cycle: work that could have been begun in it was left over.
    virtual bool has_backlog() const {
        return std::any_of(inputs_.begin(), inputs_.end(), [this](const Link* input) {
            return input->arrival() <= now();
        });
    }

    // Accounts all cycles up to and including the current one.
    void settle() { account_until(clock_.now()); }

    // The unit is due at cycle `at`, if not before.
    [[gnu::always_inline]] void wake(Cycle at) {
        if (attached_) clock_.wake(place_, at);
    }
    void wake() { wake(clock_.now() + 1); }

    // Units are evaluated in the order in which they were attached; no result depends on it.
    void attach() {
        place_ = clock_.attach(*this);
        attached_ = true;
    }

    // By the clock: a cycle in which the unit is due.
    void run_cycle() {
        rest_ = Activity::Busy;
        const Activity activity = step();
        if (shown_in_) *shown_in_ |= shown_bits_;
        if (activity != last_) {
            account_until(clock_.now() - 1);
            const bool was_busy = activity == Activity::Busy && rests_from_ == clock_.now();
            since_ = was_busy ? busy_since_ : clock_.now();
            last_ = activity;
            if (observer_) observer_->changed(number_, activity, clock_.now());
        }
        if (activity == Activity::Busy && rest_ != Activity::Busy && may_rest_)
            return come_to_rest();
        const bool goes_on = goes_on_while_busy_ && activity == Activity::Busy;
        Cycle due = goes_on ? clock_.now() + 1 : next_work(activity);
        if (has_far_inputs_ && due > clock_.now() + 1) due = std::min(due, next_arrival());
        clock_.wake(place_, due);
    }

    // The bits are set in `called` in each cycle in which step() is, so that one look tells of many
    // units; who wants to be told of the cycle behind the last busy one, too, `sees_rest`. Before
    // the first cycle.
    void show_calls_in(std::uint64_t& called, std::uint64_t bits, bool sees_rest) {
        shown_in_ = &called;
        shown_bits_ = bits;
        may_rest_ &= !sees_rest;
    }

    // The observer, or null, is told under this number.
    void set_observer(ActivityObserver* observer, std::size_t number) {
        observer_ = observer;
        number_ = number;
        may_rest_ &= observer == nullptr; // It is told of a change when it comes.
    }
    bool is_observed() const { return observer_ != nullptr; }

    // By a channel of which the unit is the consumer, or the producer.
    void add_input(const Link& input, Cycle latency) {
        inputs_.push_back(&input);
        has_far_inputs_ |= latency >= Calendar::Pages;
        may_rest_ &= !has_far_inputs_;
    }
    void add_output(const Link& output) { outputs_.push_back(&output); }

protected:
    Unit(sc_core::sc_module_name name, const Clock& clock)
        : sc_module(name)
        , clock_(clock)
        , account_(static_cast<const char*>(name)) {}

    // One cycle. Reads channels as they stood when the cycle began.
    virtual Activity step() = 0;

    // Asked after each cycle (but see go_on_while_busy) with what it was: the next one in which
    // step() may do something, or say something else, uncalled by a channel or wake(). Units that
    // count cycles say more; the count is kept as the cycle of its end: they may be called before.
    virtual Cycle next_work(Activity last) const {
        return last == Activity::Busy ? now() + 1 : Never;
    }

    // By one that counts no cycles: behind a busy cycle it is due in the next one, and need not be
    // asked.
    void go_on_while_busy() { goes_on_while_busy_ = true; }

    Cycle now() const { return clock_.now(); }

    // By step(), in a busy cycle: in those that follow, until somebody calls the unit, it would do
    // nothing and say this, so that it need not be asked.
    void rest_as(Activity activity) { rest_ = activity; }

    // The machine may have to wait for the host from now on.
    void ask_whether_to_wait() { clock_.ask(); }

private:
    void come_to_rest() {
        account_until(clock_.now());
        busy_since_ = since_;
        since_ = rests_from_ = clock_.now() + 1;
        last_ = rest_;
    }

    // Of what is on its way to the unit. Each push wakes it for the arrival, but of what is beyond
    // its pages the calendar keeps the soonest alone.
    Cycle next_arrival() const {
        Cycle next = Never;
        for (const Link* const input : inputs_)
            if (input->arrival() > clock_.now()) next = std::min(next, input->arrival());
        return next;
    }

    void account_until(Cycle end) {
        if (end > accounted_) account_.add(last_, end - accounted_);
        accounted_ = end;
    }

    const Clock& clock_;
    Account account_;
    std::vector<const Link*> inputs_, outputs_;
    bool has_far_inputs_ = false, goes_on_while_busy_ = false;
    Activity last_ = Activity::Idle; // of all cycles since accounted_
    Activity rest_ = Activity::Busy; // of the cycles to come; Busy: it has to be asked
    bool may_rest_ = true;
    Cycle rests_from_ = 0; // the last time
    Cycle busy_since_ = 1; // before
    std::uint64_t* shown_in_ = nullptr;
    std::uint64_t shown_bits_ = 0;
    Cycle accounted_ = 0;
    Cycle since_ = 1;
    std::size_t place_ = 0; // in the clock's walk
    bool attached_ = false;
    ActivityObserver* observer_ = nullptr;
    std::size_t number_ = 0; // for it
};

} // namespace ffgpu::timing
