// Channel: the only way two units talk. Bounded, and at least one cycle long: what is pushed in
// cycle n can be popped from cycle n + latency on, and a place that is freed in cycle n can be
// taken from n + 1 on. Both ends see the channel as it stood when the cycle began, so the order in
// which SystemC calls the units cannot be seen in a result.

#pragma once

#include "model/base/check.h"
#include "model/timing/unit.h"

#include <cstddef>
#include <vector>

namespace ffgpu::timing {

template <class T>
class Channel {
public:
    Channel(const Clock& clock, std::size_t capacity, Cycle latency = 1)
        : clock_(clock)
        , items_(capacity)
        , latency_(latency) {
        check(capacity > 0, "a channel needs a place");
        check(latency > 0, "a channel without latency would show the order of evaluation");
    }

    // Both ends are known before the simulation starts.
    void connect(Unit& producer, Unit& consumer) {
        producer_ = &producer;
        consumer_ = &consumer;
    }

    bool can_push() const { return taken_at_start() < items_.size(); }
    // At least n places.
    bool can_push(std::size_t n) const { return taken_at_start() + n <= items_.size(); }
    void push(const T& item) {
        check(can_push(), "push into a full channel");
        items_[(first_ + count_) % items_.size()] = {clock_.now() + latency_, item};
        ++count_;
        if (consumer_) consumer_->wake();
    }

    bool can_pop() const { return count_ > 0 && items_[first_].ready_at <= clock_.now(); }
    const T& front() const {
        check(can_pop(), "front of an empty channel");
        return items_[first_].value;
    }
    T pop() {
        check(can_pop(), "pop from an empty channel");
        T value = items_[first_].value;
        first_ = (first_ + 1) % items_.size();
        --count_;
        if (last_pop_ != clock_.now()) {
            last_pop_ = clock_.now();
            popped_now_ = 0;
        }
        ++popped_now_;
        if (producer_) producer_->wake();
        return value;
    }

    // As it is, not as it was when the cycle began: for may_sleep().
    bool holds_nothing() const { return count_ == 0; }
    bool is_full() const { return count_ == items_.size(); }

private:
    struct Item {
        Cycle ready_at = 0;
        T value{};
    };

    // Places popped in this cycle are still taken.
    std::size_t taken_at_start() const {
        return count_ + (last_pop_ == clock_.now() ? popped_now_ : 0);
    }

    const Clock& clock_;
    std::vector<Item> items_;
    Cycle latency_;
    std::size_t first_ = 0, count_ = 0;
    Cycle last_pop_ = 0;
    std::size_t popped_now_ = 0;
    Unit* producer_ = nullptr;
    Unit* consumer_ = nullptr;
};

} // namespace ffgpu::timing
