// Each timing of the DRAM at both sides of its edge: when data begin, from the parameters alone.

#include "tests/timing/nobody_watches.h"

#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

MemoryConfig plain() {
    MemoryConfig config;
    config.banks = 8;
    config.burst_cycles = config.column_to_column_cycles = 4;
    config.read_to_precharge_cycles = 4;
    config.refresh_interval_cycles = 0;
    return config;
}

struct Timed {
    DramRequest request;
    MemoryCycle at = 0;
};

// When the data of each request begin; each arrives at its time.
std::vector<MemoryCycle> data_begin(const MemoryConfig& config, const std::vector<Timed>& list) {
    NobodyWatches nobody;
    DramChannel channel(config, 0, nobody);
    std::vector<DramRequest> requests;
    std::vector<MemoryCycle> begin(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        channel.advance(list[i].at);
        DramRequest request = list[i].request;
        request.payload = &begin[i];
        channel.push(request, list[i].at);
    }
    channel.advance(100'000);
    for (; !channel.served().empty(); channel.served().pop_front()) {
        const ServedRequest& served = channel.served().front();
        *static_cast<MemoryCycle*>(served.request.payload) = served.data.begin;
    }
    return begin;
}

DramRequest read(std::uint32_t bank, std::uint64_t row) {
    return {.bank = bank, .row = row, .bytes = 32};
}
DramRequest write(std::uint32_t bank, std::uint64_t row) {
    return {.bank = bank, .row = row, .bytes = 32, .write = true};
}

TEST_CASE("the first read waits for tRCD and CL, the next only for the bus") {
    for (const std::uint32_t cl : {0u, 3u, 64u}) {
        for (const std::uint32_t rcd : {0u, 1u, 4u, 9u}) {
            MemoryConfig config = plain();
            config.column_cycles = cl;
            config.row_to_column_cycles = rcd;
            const auto begin = data_begin(config, {{read(0, 1)}, {read(0, 1)}, {read(0, 1)}});
            // An activate takes a command slot of its own.
            const MemoryCycle first = std::max(rcd, 1u) + cl;
            CHECK(begin == std::vector<MemoryCycle>{first, first + 4, first + 8});
        }
    }
}

TEST_CASE("another row of the bank waits for tRAS, tRTP, tRP") {
    for (const std::uint32_t ras : {4u, 7u, 8u, 9u, 20u}) {
        MemoryConfig config = plain();
        config.row_active_cycles = ras;
        const auto begin = data_begin(config, {{read(0, 1)}, {read(0, 2)}});
        const MemoryCycle precharge = std::max(ras, 4u + config.read_to_precharge_cycles);
        CHECK(begin[1] == precharge + config.precharge_cycles + 4 + config.column_cycles);
    }
}

TEST_CASE("another row after a write waits for tWR") {
    for (const std::uint32_t wr : {0u, 1u, 5u}) {
        MemoryConfig config = plain();
        config.write_recovery_cycles = wr;
        const auto begin = data_begin(config, {{write(0, 1)}, {read(0, 2)}});
        const MemoryCycle written = 4 + config.write_column_cycles + 4;
        CHECK(begin[1] ==
              std::max<MemoryCycle>(config.row_active_cycles, written + wr) + 4 + 4 + 3);
    }
}

TEST_CASE("activates of two banks are tRRD apart and overlap") {
    for (const std::uint32_t rrd : {0u, 1u, 3u, 4u, 5u, 12u}) {
        MemoryConfig config = plain();
        config.activate_to_activate_cycles = rrd;
        const auto begin = data_begin(config, {{read(0, 1)}, {read(1, 1)}});
        // The first read takes the command slot of cycle 4.
        const MemoryCycle activate = rrd == 4 ? 5 : std::max(rrd, 1u);
        CHECK(begin[1] == 3 + std::max<MemoryCycle>(4 + 4, activate + 4));
    }
}

TEST_CASE("the fifth activate waits for tFAW") {
    for (const std::uint32_t faw : {0u, 11u, 12u, 13u, 40u}) {
        MemoryConfig config = plain();
        config.burst_cycles = config.column_to_column_cycles = 1;
        config.row_to_column_cycles = 20; // so that no column takes an activate's slot
        config.activate_to_activate_cycles = 3;
        config.four_activates_cycles = faw;
        std::vector<Timed> list;
        for (std::uint32_t bank = 0; bank < 5; ++bank) {
            list.push_back({read(bank, 1)});
            list.back().request.bytes = 8;
        }
        CHECK(data_begin(config, list)[4] == std::max(12u, faw) + 20 + 3);
    }
}

TEST_CASE("a read after a write waits for tWTR, a write after a read for tRTW") {
    for (const std::uint32_t cycles : {0u, 1u, 6u}) {
        MemoryConfig config = plain();
        config.write_to_read_cycles = config.read_to_write_cycles = cycles;
        const auto to_read = data_begin(config, {{write(0, 1)}, {read(0, 1)}});
        CHECK(to_read[1] == 4 + 1 + 4 + cycles + 3);
        const auto to_write = data_begin(config, {{read(0, 1)}, {write(0, 1)}});
        CHECK(to_write[1] == 4 + 3 + 4 + cycles);
    }
}

TEST_CASE("a column waits for tCCD where that is longer than a burst") {
    for (const std::uint32_t ccd : {1u, 4u, 5u, 9u}) {
        MemoryConfig config = plain();
        config.column_to_column_cycles = ccd;
        const auto begin = data_begin(config, {{read(0, 1)}, {read(0, 1)}});
        CHECK(begin[1] == begin[0] + std::max(ccd, 4u));
    }
}

TEST_CASE("a refresh comes after tREFI and holds the banks for tRFC") {
    MemoryConfig config = plain();
    config.refresh_interval_cycles = 1000;
    config.refresh_cycles = 30;
    // Just early enough: the row opens, and the refresh has to wait for its precharge.
    const auto before = data_begin(config, {{read(0, 1), 995}});
    CHECK(before[0] == 995 + 4 + 3);
    const auto at = data_begin(config, {{read(0, 1), 1000}});
    CHECK(at[0] == 1000 + 30 + 4 + 3);
    const auto within = data_begin(config, {{read(0, 1), 1029}});
    CHECK(within[0] == 1000 + 30 + 4 + 3);
    const auto after = data_begin(config, {{read(0, 1), 1031}});
    CHECK(after[0] == 1031 + 4 + 3);
    // An open row closes first: tRP; and a while without requests changes nothing.
    const auto open = data_begin(config, {{read(0, 1), 7950}, {read(0, 1), 8000}});
    CHECK(open[1] == 8000 + 4 + 30 + 4 + 3);
}

TEST_CASE("pages stay open, close at once, or close after a while") {
    const auto second_row = [](PagePolicy policy, std::uint64_t row, MemoryCycle at) {
        MemoryConfig config = plain();
        config.page_policy = policy;
        config.page_timeout_cycles = 50;
        return data_begin(config, {{read(0, 1)}, {read(0, row), at}})[1] - at;
    };
    constexpr MemoryCycle Hit = 3, Closed = 4 + 3, Conflict = 4 + 4 + 3;
    CHECK(second_row(PagePolicy::Open, 1, 300) == Hit);
    CHECK(second_row(PagePolicy::Open, 2, 300) == Conflict);
    CHECK(second_row(PagePolicy::Closed, 1, 300) == Closed);
    CHECK(second_row(PagePolicy::Closed, 2, 300) == Closed);
    CHECK(second_row(PagePolicy::Timeout, 1, 4 + 49) == Hit);
    CHECK(second_row(PagePolicy::Timeout, 2, 4 + 50 + 4) == Closed);
    CHECK(second_row(PagePolicy::Timeout, 1, 4 + 50 + 4) == Closed);
}

TEST_CASE("the adaptive policy learns what the rows of a bank are like") {
    const auto latest = [](std::uint64_t step) { // the last six of ten accesses
        MemoryConfig config = plain();
        config.page_policy = PagePolicy::Adaptive;
        std::vector<Timed> list;
        for (std::uint64_t i = 0; i < 10; ++i)
            list.push_back({read(0, 1 + i * step), 300 * i});
        std::vector<MemoryCycle> begin = data_begin(config, list);
        for (std::uint64_t i = 0; i < begin.size(); ++i)
            begin[i] -= 300 * i;
        return std::vector<MemoryCycle>(begin.begin() + 4, begin.end());
    };
    CHECK(latest(0) == std::vector<MemoryCycle>(6, 3));     // one row: stays open
    CHECK(latest(1) == std::vector<MemoryCycle>(6, 4 + 3)); // always another: closed behind each
}

TEST_CASE("no request is passed by more than reorder_limit younger ones") {
    for (const std::uint32_t limit : {0u, 1u, 5u, 64u}) {
        MemoryConfig config = plain();
        config.queue = 32;
        config.reorder_limit = limit;
        NobodyWatches nobody;
        DramChannel channel(config, 0, nobody);
        std::vector<std::size_t> order;
        std::vector<std::size_t> numbers(4000);
        std::size_t pushed = 0;
        // Three of four want row 1 of bank 0: hits without end.
        for (MemoryCycle now = 0; order.size() < numbers.size(); ++now) {
            for (; pushed < numbers.size() && channel.has_room(); ++pushed) {
                numbers[pushed] = pushed;
                DramRequest request = read(0, pushed % 4 == 3 ? 2 + pushed : 1);
                if (pushed % 16 == 7) request.bank = 3;
                request.payload = &numbers[pushed];
                channel.push(request, now);
            }
            channel.advance(now + 1);
            for (; !channel.served().empty(); channel.served().pop_front())
                order.push_back(
                    *static_cast<std::size_t*>(channel.served().front().request.payload));
        }
        std::size_t most = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const auto younger = static_cast<std::size_t>(
                std::count_if(order.begin(),
                              order.begin() + static_cast<std::ptrdiff_t>(i),
                              [&](std::size_t other) { return other > order[i]; }));
            most = std::max(most, younger);
        }
        INFO("limit " << limit);
        CHECK(most == limit); // reached, never exceeded
    }
}

} // namespace
} // namespace ffgpu::timing
