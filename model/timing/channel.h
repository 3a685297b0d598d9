// Channel: the only way two units talk: a delay line and the queue at its end. What is pushed in
// cycle n can be popped from cycle n + latency on; a place that is freed in cycle n can be taken
// from n + 1 on. Both ends see the channel as it stood when the cycle began, so the order in which
// the units are called cannot be seen in a result.
//
// Latency is not throughput: the delay line has a place for every item that is on its way, `width`
// a cycle, beside the queue's own. An item holds its place from the cycle of its push to that of
// its pop, latency + 1 cycles, and there are queue + (latency - 1) width places: w items a cycle
// flow at any latency through a queue of 2 w, and latency of latency + 1 cycles carry an item
// through a queue of one.

#pragma once

#include "model/base/check.h"
#include "model/timing/unit.h"

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ffgpu::timing {

struct MemoryRequest;

// What an item is, for people; an item says so by key().
template <class T>
std::string key_of(const T& item) {
    if constexpr (requires { item.key(); }) return item.key();
    if constexpr (std::is_integral_v<T>) return std::to_string(item);
    return {};
}

template <class T>
class Channel final : public Link {
public:
    // `queue`: places at the end; `width`: items that may enter the delay line in a cycle.
    Channel(const Clock& clock, std::size_t queue, Cycle latency = 1, std::size_t width = 1)
        : Link(queue + (latency - 1) * width,
               latency,
               std::is_same_v<T, MemoryRequest>,
               std::is_same_v<T, std::uint64_t>)
        , clock_(clock)
        , items_(places()) {
        check(queue > 0 && width > 0, "a channel needs a place");
        check(latency > 0, "a channel without latency would show the order of evaluation");
    }

    // Both ends are known before the simulation starts. `name`: in reports and statistics.
    void connect(std::string name, Unit& producer, Unit& consumer) {
        name_ = std::move(name);
        producer_ = &producer;
        consumer_ = &consumer;
        producer.add_output(*this);
        consumer.add_input(*this, latency_);
    }

    // At least n places. Who is refused is woken when there is one more.
    bool can_push(std::size_t n = 1) const {
        if (taken_at_start(clock_.now()) + n <= places_) return true;
        refuse();
        return false;
    }
    // Inlined: an item that was put together just now would have to wait to be read as a whole.
    [[gnu::always_inline]] void push(const T& item) {
        const Cycle now = clock_.now(), ready_at = now + latency_;
        check(taken_at_start(now) < places_, "push into a full channel");
        std::size_t last = first_ + count_;
        if (last >= places_) last -= places_;
        Item& place = items_[last];
        place.ready_at = ready_at;
        place.value = item;
        count_before(now);
        pushed_at_ = now;
        ++pushed_;
        if (count_++ == 0) arrival_ = ready_at;
        if (consumer_) consumer_->wake(ready_at);
    }

    bool can_pop() const { return arrival_ <= clock_.now(); }
    const T& front() const {
        check(can_pop(), "front of an empty channel");
        return items_[first_].value;
    }
    T pop() {
        check(can_pop(), "pop from an empty channel");
        T value = items_[first_].value;
        drop();
        return value;
    }
    // The same without a copy of front().
    [[gnu::always_inline]] void drop() {
        const Cycle at = clock_.now();
        check(arrival_ <= at, "an item taken from an empty channel");
        if (++first_ == places_) first_ = 0;
        count_before(at);
        arrival_ = --count_ > 0 ? items_[first_].ready_at : Never;
        popped_now_ = popped_at_ == at ? popped_now_ + 1 : 1;
        popped_at_ = at;
        if (!refused_) return;
        refused_ = false;
        if (producer_) producer_->wake();
    }

    // As it is, not as it was when the cycle began: for next_work().
    bool is_full() const { return count_ == places_; }

    // Items that were taken before this cycle.
    std::uint64_t popped_before() const {
        return popped() - (popped_at_ == clock_.now() ? popped_now_ : 0);
    }
    // The producer is woken by the next pop, as if it had found no place.
    void await_pop() const { refuse(); }

    // The oldest item, which may be on its way: for who looks whether the machine has to wait.
    const T& next() const {
        check(count_ > 0, "next of an empty channel");
        return items_[first_].value;
    }

    std::string front_key() const override {
        return count_ == 0 ? std::string() : key_of(items_[first_].value);
    }

private:
    struct Item {
        Cycle ready_at = 0;
        T value{};
    };

    // Places popped in this cycle are still taken.
    std::size_t taken_at_start(Cycle now) const {
        return count_ + (popped_at_ == now ? popped_now_ : 0);
    }

    // A place that was freed in this cycle is one in the next.
    void refuse() const {
        refused_ = true;
        refused_at_ = clock_.now();
        if (popped_at_ == clock_.now() && popped_now_ > 0 && producer_) producer_->wake();
    }

    const Clock& clock_;
    std::vector<Item> items_;
    std::size_t first_ = 0;
    std::size_t popped_now_ = 0;
};

} // namespace ffgpu::timing
