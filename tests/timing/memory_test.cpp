// The memory as its clients see it: bandwidth, latency, and where the buses' cycles go.

#include "model/base/input_error.h"
#include "model/timing/gpu_timing.h"
#include "tests/timing/memory_bench.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

MemoryConfig without_refresh(MemoryConfig config = {}) {
    config.refresh_interval_cycles = 0;
    return config;
}

// Cycles of data that the lines take on the buses together.
double bus_cycles(const MemoryConfig& config, std::size_t lines) {
    return static_cast<double>(lines) * 64 / config.bytes_per_cycle / config.channels;
}

TEST_CASE("a row-hit stream fills the bus whatever the latencies") {
    constexpr std::size_t Lines = 8000;
    for (const std::uint32_t column : {0u, 4u, 16u, 64u}) {
        for (const std::uint32_t latency : {0u, 100u, 4096u}) {
            MemoryConfig config;
            config.column_cycles = column;
            config.latency = latency;
            INFO("CL " << column << " latency " << latency);
            const BenchResult reads = run_memory(config, line_stream(Lines));
            CHECK(bus_cycles(config, Lines) / static_cast<double>(reads.steady_cycles()) > 0.95);
            // Writes are posted: only the last one's way is added.
            const BenchResult writes = run_memory(config, line_stream(Lines, true));
            const double cycles = static_cast<double>(writes.cycles - latency);
            CHECK(bus_cycles(config, Lines) / cycles > 0.95);
        }
    }
}

TEST_CASE("folded banks keep apart what lies a multiple of all banks apart") {
    MemoryConfig config = without_refresh();
    config.channels = 1;
    config.scheduler = SchedulerKind::InOrder;
    const std::uint64_t apart = std::uint64_t{96} * config.banks * config.row_bytes;
    constexpr std::uint64_t Lines = 16; // half a row of each
    std::vector<MemoryRequest> requests;
    for (std::uint64_t line = 0; line < Lines; ++line)
        for (const std::uint64_t base : {std::uint64_t{0}, apart})
            requests.push_back({.address = base + 64 * line, .bytes = 64});
    // In one bank each request closes the other's row.
    CHECK(run_memory(config, requests).figures.at("memory_row_conflicts") == 2 * Lines - 1);
    config.bank_hash = work::IndexHash::Xor;
    const Figures figures = run_memory(config, requests).figures;
    CHECK(figures.at("memory_row_conflicts") == 0);
    CHECK(figures.at("memory_row_misses") == 2);
}

TEST_CASE("with one request under way a line takes its latencies, and nothing else") {
    for (const std::uint32_t latency : {0u, 1u, 50u}) {
        MemoryConfig config = without_refresh();
        config.channels = 1;
        config.latency = latency;
        const BenchResult result = run_memory(config, line_stream(20), 1);
        // Client to arbiter to channel: a cycle each; the command's cycle, CL and eight cycles of
        // data; back through one link. All lines are in one row.
        const Cycle round = 1 + 1 + latency + config.column_cycles + 8 + 1 - 1;
        for (std::size_t i = 1; i < result.done.size(); ++i)
            CHECK(result.done[i].second - result.done[i - 1].second == round);
    }
}

TEST_CASE("half the bus takes twice the time, half the clock too") {
    const auto cycles = [](std::uint32_t width, std::uint32_t core, std::uint32_t memory) {
        MemoryConfig config;
        config.profile = MemoryProfile::Ideal;
        config.apply_profile();
        config.bytes_per_cycle = width;
        config.core_clocks = core;
        config.memory_clocks = memory;
        return static_cast<double>(run_memory(config, line_stream(4000)).steady_cycles());
    };
    const double whole = cycles(8, 1, 1);
    CHECK(cycles(4, 1, 1) == Approx(2 * whole).epsilon(0.001));
    CHECK(cycles(2, 1, 1) == Approx(4 * whole).epsilon(0.001));
    CHECK(cycles(8, 2, 1) == Approx(2 * whole).epsilon(0.001));
    CHECK(cycles(4, 3, 5) == Approx(2 * whole * 3 / 5).epsilon(0.001));
}

// Every request another row; banks in turn.
std::vector<MemoryRequest> rows_in_turn(const MemoryConfig& config, std::size_t count) {
    std::vector<MemoryRequest> list;
    for (std::size_t i = 0; i < count; ++i)
        list.push_back({.address = i * config.row_bytes, .bytes = 16, .client = Client::Texture});
    return list;
}

MemoryConfig one_channel(std::uint32_t banks) {
    MemoryConfig config = without_refresh();
    config.channels = 1;
    config.banks = banks;
    config.queue = 64;
    config.client_queue = 64;
    return config;
}

// A new row in each of B banks in turn: a bank takes tRC a row, activates are tRRD apart and four
// in tFAW, the bus takes a burst, and the command bus precharge, activate and read.
TEST_CASE("new rows in turn over B banks take the closed form's time") {
    for (const std::uint32_t banks : {1u, 2u, 4u, 8u, 16u, 32u}) {
        for (const std::uint32_t four : {0u, 30u}) {
            MemoryConfig config = one_channel(banks);
            config.row_active_cycles = 20;
            config.four_activates_cycles = four;
            const double row_cycle = std::max(20u, 4u + 2u) + 4;
            const double expected =
                std::max({row_cycle / banks, 3.0, four / 4.0, 2.0, 3.0 /* commands */});
            constexpr std::size_t Count = 6000;
            const BenchResult result = run_memory(config, rows_in_turn(config, Count));
            INFO(banks << " banks, tFAW " << four);
            CHECK(static_cast<double>(result.steady_cycles()) / (Count - 1) ==
                  Approx(expected).epsilon(0.02));
        }
    }
}

// Requests to random banks, each another row, auto precharge: a second simulation that knows only
// slots of a window and when each bank, the activates and the bus are free.
double random_bank_cycles(unsigned banks, unsigned window, unsigned row_cycle, unsigned rrd) {
    constexpr unsigned Burst = 2, ToColumn = 4, Count = 40000;
    struct Slot {
        std::uint64_t bank = 0;
        std::int64_t opened = -1;
    };
    Dice dice(7);
    std::vector<Slot> slots(window);
    for (Slot& slot : slots)
        slot.bank = dice.below(banks);
    std::vector<std::int64_t> free_at(banks, 0);
    std::vector<bool> in_use(banks, false); // opened, and not read yet
    std::int64_t next_open = 0, bus_free = 0, t = 0;
    for (unsigned done = 0; done < Count; ++t) {
        const auto ready = std::find_if(slots.begin(), slots.end(), [&](const Slot& slot) {
            return slot.opened >= 0 && slot.opened + ToColumn <= t && bus_free <= t;
        });
        if (ready != slots.end()) { // A command a cycle; the bank stays its row cycle.
            bus_free = t + Burst;
            free_at[ready->bank] =
                std::max<std::int64_t>(ready->opened + row_cycle, t + 2 /* tRTP */ + 4 /* tRP */);
            in_use[ready->bank] = false;
            slots.erase(ready);
            slots.push_back({dice.below(banks), -1});
            ++done;
            continue;
        }
        if (t < next_open) continue;
        const auto closed = std::find_if(slots.begin(), slots.end(), [&](const Slot& slot) {
            return slot.opened < 0 && !in_use[slot.bank] && free_at[slot.bank] <= t;
        });
        if (closed == slots.end()) continue;
        closed->opened = t;
        in_use[closed->bank] = true;
        next_open = t + rrd;
    }
    return static_cast<double>(t) / Count;
}

TEST_CASE("random rows over B banks take the time of an independent simulation") {
    for (const std::uint32_t banks : {1u, 2u, 4u, 8u, 16u}) {
        for (const std::uint32_t queue : {1u, 4u, 16u}) {
            MemoryConfig config = one_channel(banks);
            config.page_policy = PagePolicy::Closed;
            config.row_active_cycles = 20;
            config.queue = queue;
            constexpr std::size_t Count = 20000;
            Dice dice(3);
            std::vector<MemoryRequest> list;
            for (std::size_t i = 0; i < Count; ++i)
                list.push_back({.address = (i * banks + dice.below(banks)) * config.row_bytes,
                                .bytes = 16,
                                .client = Client::Texture});
            const BenchResult result = run_memory(config, list);
            INFO(banks << " banks, queue " << queue);
            CHECK(static_cast<double>(result.steady_cycles()) / (Count - 1) ==
                  Approx(random_bank_cycles(banks, queue, 24, 3)).epsilon(0.02));
        }
    }
}

TEST_CASE("refresh costs what closing, tRFC and opening take, once in tREFI") {
    MemoryConfig config = one_channel(4);
    config.refresh_interval_cycles = 700;
    config.refresh_cycles = 50;
    constexpr std::size_t Lines = 20000;
    std::vector<MemoryRequest> list = line_stream(Lines);
    for (MemoryRequest& request : list)
        request.address %= config.row_bytes; // One row, always a hit but for the refresh.
    const BenchResult result = run_memory(config, list);
    const double cycles = static_cast<double>(result.steady_cycles());
    const double refreshes = std::floor(cycles / 700);
    const double lost = (cycles - Lines * 8.0) / refreshes;
    // From the last column (its data run on) to the next: at most a line before, PRE, REF, ACT.
    const double between = 4 + 50 + 4; // tRP, tRFC, tRCD
    CHECK(lost > between - 8);
    CHECK(lost < between + 8 + 2); // tRTP
    CHECK(result.figures.at("memory_refreshes") == Approx(cycles / 700).margin(1));
    CHECK(static_cast<double>(result.figures.at("memory_lost_refresh_cycles")) / refreshes ==
          Approx(between).margin(8));
}

TEST_CASE("a row holds row_bytes, whatever the interleave") {
    for (const std::uint32_t interleave : {64u, 256u, 2048u, 65536u}) {
        MemoryConfig config = without_refresh();
        config.interleave_bytes = interleave;
        constexpr std::size_t Lines = 8192;
        const Figures figures = run_memory(config, line_stream(Lines)).figures;
        INFO("interleave " << interleave);
        CHECK(figures.at("memory_row_misses") + figures.at("memory_row_conflicts") ==
              Lines * 64 / config.row_bytes);
    }
}

std::vector<MemoryRequest> random_requests(std::uint64_t seed, std::size_t count) {
    Dice dice(seed);
    std::vector<MemoryRequest> list;
    std::uint64_t address = 0;
    for (std::size_t i = 0; i < count; ++i) {
        address = dice.below(3) == 0 ? dice.below(1 << 14) * 64 : address + 64;
        list.push_back({.address = address,
                        .bytes = static_cast<std::uint32_t>(16 << dice.below(3)),
                        .write = dice.below(4) == 0,
                        .client = Client::Texture});
    }
    return list;
}

TEST_CASE("data and lost cycles by cause add up to channels times cycles, bytes to bytes") {
    Dice dice(11);
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        MemoryConfig config;
        config.profile = static_cast<MemoryProfile>(dice.below(4));
        config.apply_profile();
        config.channels = 1u << dice.below(4);
        config.banks = 1u << dice.below(5);
        config.interleave_bytes = 64u << dice.below(8);
        config.bytes_per_cycle = 1u << dice.below(6);
        config.core_clocks = static_cast<std::uint32_t>(1 + dice.below(3));
        config.memory_clocks = static_cast<std::uint32_t>(1 + dice.below(3));
        config.queue = static_cast<std::uint32_t>(1 + dice.below(20));
        config.client_queue = static_cast<std::uint32_t>(2 + dice.below(20));
        config.latency = static_cast<std::uint32_t>(dice.below(200));
        config.scheduler = static_cast<SchedulerKind>(dice.below(2));
        config.reorder_limit = static_cast<std::uint32_t>(dice.below(40));
        config.page_policy = static_cast<PagePolicy>(dice.below(4));
        config.column_to_column_cycles = static_cast<std::uint32_t>(1 + dice.below(6));
        config.four_activates_cycles = static_cast<std::uint32_t>(dice.below(40));
        const std::vector<MemoryRequest> list = random_requests(seed, 600);
        const BenchResult result = run_memory(config, list, 1 + dice.below(100));
        const Figures& figures = result.figures;
        INFO("seed " << seed);
        const Cycle memory_cycles = result.cycles * config.memory_clocks / config.core_clocks;
        CHECK(figures.at("memory_bus_cycles") == memory_cycles * config.channels);
        CHECK(accounted_cycles(figures) == memory_cycles * config.channels);

        std::uint64_t read = 0, written = 0, data = 0;
        for (const MemoryRequest& request : list) {
            (request.write ? written : read) += request.bytes;
            data += (request.bytes + config.bytes_per_cycle - 1) / config.bytes_per_cycle;
        }
        CHECK(figures.at("memory_texture_read_bytes") == read);
        CHECK(figures.at("memory_texture_written_bytes") == written);
        CHECK(figures.at("memory_data_cycles") == data);
        CHECK(figures.at("memory_row_hits") + figures.at("memory_row_misses") +
                  figures.at("memory_row_conflicts") ==
              list.size());
    }
}

TEST_CASE("lost cycles have the cause that was arranged") {
    const auto share = [](const Figures& figures, const std::string& cause) {
        return static_cast<double>(figures.at("memory_lost_" + cause + "_cycles")) /
               static_cast<double>(figures.at("memory_bus_cycles"));
    };
    // One bank, always another row: 2 cycles of data in 24.
    MemoryConfig one_bank = one_channel(1);
    one_bank.row_active_cycles = 20;
    CHECK(share(run_memory(one_bank, rows_in_turn(one_bank, 2000)).figures, "row") ==
          Approx(22.0 / 24).epsilon(0.02));
    // Many banks, activates far apart.
    MemoryConfig apart = one_channel(16);
    apart.activate_to_activate_cycles = 12;
    CHECK(share(run_memory(apart, rows_in_turn(apart, 2000)).figures, "activates") ==
          Approx(10.0 / 12).epsilon(0.02));
    // A read and a write in turn, kept in order: the bus turns twice for sixteen cycles of data.
    MemoryConfig turning = one_channel(4);
    turning.scheduler = SchedulerKind::InOrder;
    turning.read_to_write_cycles = 5;
    turning.write_to_read_cycles = 6;
    std::vector<MemoryRequest> list = line_stream(2000);
    for (std::size_t i = 0; i < list.size(); ++i) {
        list[i].write = i % 2 == 1;
        list[i].address %= turning.row_bytes;
    }
    const double lost = 5 + 6 + turning.column_cycles;
    CHECK(share(run_memory(turning, list).figures, "turnaround") ==
          Approx(lost / (16 + lost)).epsilon(0.02));
    // So of each kind of DRAM: a pair loses CL + tWTR and tRTW to turns. A read's column goes
    // WL + tWTR behind the end of the write's own cycles, which tCCD alone may delay further.
    for (const MemoryProfile profile :
         {MemoryProfile::Sdr, MemoryProfile::Ddr, MemoryProfile::Gddr3})
        for (const std::uint32_t farther : {0u, 1u, 3u, 9u}) {
            MemoryConfig kind = one_channel(4);
            kind.profile = profile;
            kind.apply_profile();
            kind.scheduler = SchedulerKind::InOrder;
            kind.refresh_interval_cycles = 0;
            kind.bytes_per_cycle = list[0].bytes / kind.burst_cycles; // of a request: one burst
            kind.column_to_column_cycles = kind.burst_cycles + farther;
            const Figures figures = run_memory(kind, list).figures;
            const std::uint32_t turns =
                kind.column_cycles + kind.write_to_read_cycles + kind.read_to_write_cycles;
            INFO("profile " << static_cast<int>(profile) << ", farther " << farther);
            const int to_read = static_cast<int>(farther - kind.write_column_cycles) -
                                static_cast<int>(kind.write_to_read_cycles);
            const int to_write = static_cast<int>(farther + kind.write_column_cycles) -
                                 static_cast<int>(kind.column_cycles + kind.read_to_write_cycles);
            CHECK(figures.at("memory_lost_turnaround_cycles") ==
                  999 * turns + kind.read_to_write_cycles);
            CHECK(figures.at("memory_lost_column_cycles") ==
                  999u * static_cast<unsigned>(std::max(to_read, 0)) +
                      1000u * static_cast<unsigned>(std::max(to_write, 0)));
        }
    // Half of each burst is not asked for.
    MemoryConfig wide = one_channel(4);
    wide.burst_cycles = wide.column_to_column_cycles = 16;
    std::vector<MemoryRequest> half = line_stream(2000);
    for (MemoryRequest& request : half)
        request.address %= wide.row_bytes;
    CHECK(share(run_memory(wide, half).figures, "burst") == Approx(0.5).epsilon(0.02));
    // One at a time.
    MemoryConfig far = one_channel(4);
    far.latency = 300;
    CHECK(share(run_memory(far, half, 1).figures, "no_request") > 0.95);
}

TEST_CASE("latency counts from the client's request, its wait for the arbiter included") {
    MemoryConfig config;
    config.client_queue = 64;
    const BenchResult result = run_memory(config, line_stream(3000));
    const std::uint64_t counted = result.figures.at("memory_texture_read_latency_cycles");
    // The client takes its data a cycle after they were sent.
    CHECK(counted + 3000 == result.waited);
    std::uint64_t in_histogram = 0;
    for (const auto& [name, value] : result.figures) {
        if (name.starts_with("memory_texture_read_latency_") && !name.ends_with("_cycles"))
            in_histogram += value;
    }
    CHECK(in_histogram == 3000);
    CHECK(ClientStatistics::bucket(31) == 0);
    CHECK(ClientStatistics::bucket(32) == 1);
    CHECK(ClientStatistics::bucket(1023) == 5);
    CHECK(ClientStatistics::bucket(1024) == 6);
    CHECK(ClientStatistics::bucket(1 << 20) == 6);
}

TEST_CASE("a line longer than the interleave or the row is refused by name") {
    const auto wanted = [](std::uint32_t line, std::uint32_t interleave, std::uint32_t channels) {
        TimingConfig config;
        config.texel_cache.line_bytes = line;
        config.memory.interleave_bytes = interleave;
        config.memory.channels = channels;
        config.memory.row_bytes = 256;
        const GpuTiming timing(config);
    };
    CHECK_NOTHROW(wanted(256, 256, 2));
    CHECK_NOTHROW(wanted(128, 64, 1));
    CHECK_THROWS_WITH(wanted(128, 64, 2),
                      "texel_cache.line_bytes: expected at most memory.interleave_bytes (64), "
                      "found 128");
    CHECK_THROWS_WITH(wanted(512, 64, 1),
                      "texel_cache.line_bytes: expected at most memory.row_bytes (256), found 512");
}

TEST_CASE("the defaults are the profile that they name") {
    for (const MemoryProfile profile : {MemoryProfile::Sdr, MemoryProfile::Gddr3}) {
        MemoryConfig config;
        config.profile = profile;
        config.apply_profile();
        CHECK_FALSE(config == MemoryConfig{});
        config.profile = MemoryProfile::Ddr;
        config.apply_profile();
        CHECK(config == MemoryConfig{});
    }
}

} // namespace
} // namespace ffgpu::timing
