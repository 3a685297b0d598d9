// A channel between a producer and a consumer that move `width` items a cycle: how long n items
// take, from closed forms.

#include "model/timing/channel.h"
#include "tests/timing/bench_clock.h"

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

struct Producer : Unit {
    Producer(const Clock& clock, Channel<int>& items_out, int items, int items_per_cycle)
        : Unit("producer", clock)
        , out(items_out)
        , left(items)
        , width(items_per_cycle) {}
    Activity step() override {
        Activity activity = Activity::Idle;
        for (int i = 0; i < width && left > 0 && out.can_push(); ++i) {
            if (first_push == 0) first_push = now();
            out.push(left--);
            activity = Activity::Busy;
        }
        return activity;
    }

    Channel<int>& out;
    int left;
    const int width;
    Cycle first_push = 0;
};

struct Consumer : Unit {
    Consumer(const Clock& clock, Channel<int>& items_in, int items_per_cycle)
        : Unit("consumer", clock)
        , in(items_in)
        , width(items_per_cycle) {}
    Activity step() override {
        Activity activity = Activity::Idle;
        for (int i = 0; i < width && in.can_pop(); ++i) {
            in.pop();
            ++received;
            last_pop = now();
            activity = Activity::Busy;
        }
        return activity;
    }

    Channel<int>& in;
    const int width;
    int received = 0;
    Cycle last_pop = 0;
};

struct Link {
    std::size_t queue = 2;
    Cycle latency = 1;
    int width = 1;
};

// Cycles from the first push to the last pop, the same for both orders of evaluation.
Cycle drain(const Link& link, int items) {
    Cycle cycles[2] = {};
    for (const bool consumer_first : {false, true}) {
        BenchClock bench;
        Channel<int> channel(
            bench.clock, link.queue, link.latency, static_cast<std::size_t>(link.width));
        Producer producer(bench.clock, channel, items, link.width);
        Consumer consumer(bench.clock, channel, link.width);
        channel.connect("channel", producer, consumer);
        consumer_first ? consumer.attach() : producer.attach();
        consumer_first ? producer.attach() : consumer.attach();
        bench.run_until([&] { return consumer.received == items; });
        cycles[consumer_first] = consumer.last_pop - producer.first_push;
    }
    CHECK(cycles[0] == cycles[1]);
    return cycles[0];
}

TEST_CASE("a queue of two carries an item a cycle at any latency: fill + n - 1 cycles") {
    const int items = 500;
    for (const Cycle latency : {1u, 2u, 3u, 12u, 100u, 499u, 500u, 10000u}) {
        for (const std::size_t queue : {2u, 3u, 16u}) {
            INFO("latency " << latency << " queue " << queue);
            CHECK(drain({queue, latency}, items) == latency + items - 1);
        }
    }
}

TEST_CASE("a queue of one loses a cycle every `latency` items") {
    for (const Cycle latency : {1u, 2u, 3u, 12u, 100u, 10000u}) {
        for (const int items : {1, 2, 12, 13, 25, 300}) {
            INFO("latency " << latency << " items " << items);
            const auto lost = static_cast<Cycle>(items - 1) / latency;
            CHECK(drain({1, latency}, items) == latency + static_cast<Cycle>(items) - 1 + lost);
        }
    }
}

TEST_CASE("a queue of twice the width carries the whole width, one place less does not") {
    for (const int width : {2, 4, 16}) {
        for (const Cycle latency : {1u, 2u, 12u, 100u}) {
            const int items = width * 300;
            const auto two = 2 * static_cast<std::size_t>(width);
            INFO("width " << width << " latency " << latency);
            CHECK(drain({two, latency, width}, items) == latency + 300 - 1);
            CHECK(drain({two - 1, latency, width}, items) > latency + 300 - 1);
        }
    }
}

TEST_CASE("a stopped consumer leaves room for the delay line and the queue, no more") {
    BenchClock bench;
    Channel<int> channel(bench.clock, 3, 5);
    int pushed = 0;
    for (; channel.can_push(); ++pushed)
        channel.push(pushed);
    CHECK(pushed == 3 + 4);
    CHECK(channel.is_full());
    CHECK_FALSE(channel.can_pop());
    bench.run(4);
    CHECK_FALSE(channel.can_pop());
    bench.run(1);
    REQUIRE(channel.can_pop());
    CHECK(channel.pop() == 0);
    CHECK_FALSE(channel.can_push()); // Freed in this cycle: free from the next on.
    bench.run(1);
    CHECK(channel.can_push());
    CHECK_FALSE(channel.can_push(2));
}

} // namespace
} // namespace ffgpu::timing
