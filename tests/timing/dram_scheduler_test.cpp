// The scheduler's two forms: by bits, and plainly by looking at each request. A channel of each
// serves the same random requests.

#include "model/timing/memory/dram_channel.h"

#include <random>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

using Event = std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>;

class Recorder : public DramObserver {
public:
    std::vector<Event> events;

private:
    void on_access(std::uint32_t, const DramRequest& request, RowResult result) override {
        events.emplace_back(0, request.client, static_cast<std::uint64_t>(result));
    }
    void on_data(MemoryCycle cycles) override { events.emplace_back(1, cycles, 0); }
    void on_lost(LostTo cause, MemoryCycle cycles) override {
        events.emplace_back(2, static_cast<std::uint64_t>(cause), cycles);
    }
    void on_turnaround() override { events.emplace_back(3, 0, 0); }
    void on_refresh() override { events.emplace_back(4, 0, 0); }
};

MemoryConfig random_config(std::mt19937& random) {
    const auto one_of = [&](std::initializer_list<std::uint32_t> values) {
        return values.begin()[random() % values.size()];
    };
    MemoryConfig config;
    config.banks = one_of({1, 2, 4, 8, 16, 64});
    config.queue = one_of({1, 2, 16, 63, 64, 65, 100}); // on both sides of what has bits
    config.reorder_limit = one_of({0, 1, 3, 64});
    config.scheduler = random() % 4 == 0 ? SchedulerKind::InOrder : SchedulerKind::FirstReady;
    config.page_policy = static_cast<PagePolicy>(random() % 4);
    config.four_activates_cycles = one_of({0, 20});
    config.refresh_interval_cycles = one_of({0, 300});
    config.column_cycles = one_of({0, 3, 9});
    config.row_to_column_cycles = one_of({0, 4, 12});
    config.write_to_read_cycles = one_of({0, 3, 8});
    return config;
}

// What a channel did with the requests, a number each, that came at these times at the earliest.
std::vector<Event> served(const MemoryConfig& config, std::uint32_t seed, bool plainly) {
    std::mt19937 random(seed);
    Recorder recorder;
    DramChannel channel(config, 0, recorder, plainly);
    MemoryCycle now = 0;
    for (std::uint32_t number = 0; number < 600; ++number) {
        if (random() % 3 == 0) now += random() % 40;
        const DramRequest request{.bank = static_cast<std::uint32_t>(random() % config.banks),
                                  .row = random() % 3,
                                  .bytes = 16u << random() % 4,
                                  .write = random() % 3 == 0,
                                  .client = number};
        for (channel.advance(now); !channel.has_room(); channel.advance(now))
            ++now;
        channel.push(request, now);
    }
    channel.settle(now + 5000);
    std::vector<Event> events = std::move(recorder.events);
    for (; !channel.served().empty(); channel.served().pop_front()) {
        const ServedRequest& last = channel.served().front();
        events.emplace_back(last.request.client, last.data.begin, last.data.end);
    }
    return events;
}

TEST_CASE("requests chosen by bits are those chosen by looking at each") {
    std::mt19937 random(7);
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const MemoryConfig config = random_config(random);
        CAPTURE(seed, config.banks, config.queue, config.reorder_limit);
        const std::vector<Event> expected = served(config, seed, true);
        CHECK(expected.size() > 1200);
        CHECK(served(config, seed, false) == expected);
    }
}

} // namespace
} // namespace ffgpu::timing
