// Link: what a channel of any type tells: the units at its ends, so that they need not look in
// every cycle, and who reports what the machine is at, for how long it held how many items.

#pragma once

#include "model/timing/clock.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ffgpu::timing {

class Unit;

class Link {
public:
    Link& operator=(const Link&) = delete;

    // When the oldest item can be popped; Never where there is none.
    Cycle arrival() const { return arrival_; }

    // Items that are in the queue, or on their way to it.
    std::size_t items() const { return count_; }
    std::size_t places() const { return places_; }
    // What the oldest item is, for people; empty: there is none, or nothing to tell of it.
    virtual std::string front_key() const = 0;

    // Empty where the link was not connected.
    const std::string& name() const { return name_; }
    const Unit* producer() const { return producer_; }
    const Unit* consumer() const { return consumer_; }
    // The producer found no place, and none came free since.
    bool is_refused() const { return refused_; }
    // Items since the machine's start.
    std::uint64_t pushed() const { return pushed_; }
    std::uint64_t popped() const { return pushed_ - count_; }
    // The last cycles in which an item was pushed, one was taken, and the producer was refused.
    Cycle pushed_at() const { return pushed_at_; }
    Cycle popped_at() const { return popped_at_; }
    Cycle refused_at() const { return refused_at_; }
    // Cycles from the push of an item to its arrival.
    Cycle latency() const { return latency_; }
    // To the memory, or to a cache before it: the consumer answers.
    bool carries_requests() const { return carries_requests_; }
    // From there: tickets of requests.
    bool carries_answers() const { return carries_answers_; }

    // Of all cycles counted: in how many there were 0, 1, 2 ... items at the cycle's end, and the
    // sum of the items over the cycles.
    const std::vector<Cycle>& cycles_at() const { return cycles_at_; }
    std::uint64_t item_cycles() const { return item_cycles_; }
    // Nothing is counted from now on.
    void leave_out_counts() const { next_ = Never; }
    // Counts all cycles before `now`.
    void count_before(Cycle now) const {
        if (now <= next_) return;
        const Cycle cycles = now - std::exchange(next_, now);
        cycles_at_[count_] += cycles;
        item_cycles_ += count_ * cycles;
    }

protected:
    Link(std::size_t places, Cycle latency, bool carries_requests, bool carries_answers)
        : places_(places)
        , latency_(latency)
        , cycles_at_(places + 1)
        , carries_requests_(carries_requests)
        , carries_answers_(carries_answers) {}
    ~Link() = default;
    Link(const Link&) = default;

    std::string name_;
    Unit* producer_ = nullptr;
    Unit* consumer_ = nullptr;
    Cycle arrival_ = Never;
    std::size_t count_ = 0;
    std::uint64_t pushed_ = 0;
    mutable bool refused_ = false; // the producer, since the last pop
    const std::size_t places_;
    Cycle latency_;
    Cycle pushed_at_ = 0, popped_at_ = 0;
    mutable Cycle refused_at_ = 0;

private:
    mutable std::vector<Cycle> cycles_at_;
    mutable std::uint64_t item_cycles_ = 0;
    mutable Cycle next_ = 1; // that is counted
    bool carries_requests_, carries_answers_;
};

} // namespace ffgpu::timing
