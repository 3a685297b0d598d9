// The scheduler's two forms: by bits, and plainly by looking at each request. A channel of each
// serves the same random requests.

#include "model/timing/memory/dram_channel.h"

#include <algorithm>
#include <random>
#include <tuple>
#include <utility>
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
    config.write_column_cycles = one_of({0, 1, 12}); // Data of a read may come before a write's.
    config.read_to_write_cycles = one_of({0, 1, 30});
    config.row_to_column_cycles = one_of({0, 4, 12});
    config.write_to_read_cycles = one_of({0, 3, 8});
    config.activate_to_activate_cycles =
        one_of({0, 2, 5, 9}); // a column may yield to one held by it
    return config;
}

// What a channel did with the requests, a number each, that came at these times at the earliest.
// `for_one`: that many of eight are for one bank, besides its share.
std::vector<Event>
served(const MemoryConfig& config, std::uint32_t seed, bool plainly, std::uint32_t for_one = 0) {
    std::mt19937 random(seed);
    Recorder recorder;
    DramChannel channel(config, 0, recorder, plainly);
    MemoryCycle now = 0;
    for (std::uint32_t number = 0; number < 600; ++number) {
        if (random() % 3 == 0) now += random() % 40;
        const auto bank = static_cast<std::uint32_t>(random() % config.banks);
        const DramRequest request{.bank = for_one > 0 && random() % 8 < for_one ? 0 : bank,
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

// The same of a channel that is asked in each cycle when its next column goes out.
void check_next_columns(const MemoryConfig& config, std::uint32_t seed) {
    std::mt19937 random(seed);
    Recorder recorder;
    DramChannel channel(config, 0, recorder);
    MemoryCycle told = 0; // the latest since the last push or column
    for (MemoryCycle now = 0; now < 3000; ++now) {
        if (channel.has_room() && random() % 8 == 0) {
            told = 0;
            channel.push({.bank = static_cast<std::uint32_t>(random() % config.banks),
                          .row = random() % 3,
                          .bytes = 16u << random() % 4,
                          .write = random() % 3 == 0},
                         now);
        }
        told = std::max(told, channel.next_column());
        REQUIRE(told >= channel.next_work());
        channel.advance(now + 1);
        if (channel.served().empty()) continue;
        REQUIRE(told <= now);
        told = 0;
        channel.served().clear();
    }
}

TEST_CASE("no column goes out before the one that a channel tells of") {
    std::mt19937 random(8);
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const MemoryConfig config = random_config(random);
        CAPTURE(seed, config.banks, config.queue, config.reorder_limit);
        check_next_columns(config, seed);
    }
}

// Who is told with each column, who asks in each cycle and who does so at the end alone are told as
// much; the first two at each time.
TEST_CASE("what a channel has told of its bus hangs on no question") {
    std::mt19937 random(9);
    MemoryConfig config = random_config(random);
    enum class Asks { Never, Always, AtTheEnd };
    const auto told = [&](Asks asks) {
        std::vector<Event> at_times;
        std::mt19937 requests(10);
        Recorder recorder;
        DramChannel channel(config, 0, recorder);
        if (asks != Asks::Never) channel.tell_when_asked();
        std::uint64_t data = 0, lost = 0;
        std::size_t counted = 0;
        const auto count = [&] {
            for (; counted < recorder.events.size(); ++counted) {
                const auto& [what, first, second] = recorder.events[counted];
                if (what == 1) data += first;
                if (what == 2) lost += second;
            }
        };
        for (MemoryCycle now = 0; now < 20000; ++now) {
            if (channel.has_room() && requests() % 9 == 0)
                channel.push({.bank = static_cast<std::uint32_t>(requests() % config.banks),
                              .row = requests() % 3,
                              .bytes = 64,
                              .write = requests() % 3 == 0},
                             now);
            channel.advance(now + 1);
            if (asks == Asks::Always) channel.tell();
            count();
            if (asks != Asks::AtTheEnd) at_times.emplace_back(now, data, lost);
        }
        channel.settle(20000);
        count();
        CHECK(data + lost == 20000);
        return std::pair(std::pair(data, lost), at_times);
    };
    for (std::uint32_t i = 0; i < 40; ++i, config = random_config(random)) {
        const auto always = told(Asks::Always);
        CHECK(told(Asks::Never) == always);
        CHECK(told(Asks::AtTheEnd).first == always.first);
    }
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

// A column yields to an activate that others' activates hold; requests come in that very cycle.
TEST_CASE("what cycles were lost to stands where a column yields and requests come") {
    std::mt19937 random(11);
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        MemoryConfig config = random_config(random);
        config.banks = seed % 2 == 0 ? 4 : 8;
        config.queue = 16;
        config.burst_cycles = 2 + seed % 3;
        config.activate_to_activate_cycles = 12;
        config.row_to_column_cycles = 4 + seed % 8;
        config.page_policy = PagePolicy::Open;
        CAPTURE(seed, config.banks, config.reorder_limit);
        CHECK(served(config, seed, false) == served(config, seed, true));
    }
}

// Many more wait for one bank than for the others, whose activates step back for its.
TEST_CASE("by bits or plainly, activates step back for a bank that limits") {
    std::mt19937 random(12);
    for (std::uint32_t seed = 0; seed < 400; ++seed) {
        MemoryConfig config = random_config(random);
        config.banks = seed % 2 == 0 ? 4 : 8;
        config.queue = 16;
        config.scheduler = SchedulerKind::FirstReady;
        config.reorder_limit = 64;
        config.activate_to_activate_cycles = 7;
        config.row_to_column_cycles = 6 + seed % 8;
        config.page_policy = seed % 3 == 0 ? PagePolicy::Closed : PagePolicy::Open;
        CAPTURE(seed, config.banks);
        CHECK(served(config, seed, false, 3) == served(config, seed, true, 3));
    }
}

} // namespace
} // namespace ffgpu::timing
