// New rows over B banks in turn, by one channel: against the closed form of docs/units/memory.md.
// It asks that the commands of all banks find cycles of their own, which not all timings allow.

#include "tests/timing/memory_bench.h"
#include "tests/timing/nobody_watches.h"

#include <algorithm>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

struct Stream {
    std::uint32_t bursts = 1; // of a request
    bool write = false;
    std::uint32_t before = 0; // requests to one row, before the new rows
};

// An activate, a column and a precharge of a bank take a cycle each, whatever the timings.
double closed_form(const MemoryConfig& config, const Stream& stream) {
    const auto at_least_one = [](std::uint32_t cycles) { return std::max(cycles, 1u); };
    const std::uint32_t bursts = stream.bursts;
    const std::uint32_t columns = (bursts - 1) * config.column_spacing();
    const std::uint32_t to_precharge =
        stream.write
            ? config.write_column_cycles + config.burst_cycles + config.write_recovery_cycles
            : config.read_to_precharge_cycles;
    const std::uint32_t row_cycle =
        std::max(config.row_active_cycles,
                 at_least_one(config.row_to_column_cycles) + columns + at_least_one(to_precharge)) +
        at_least_one(config.precharge_cycles);
    return std::max({static_cast<double>(row_cycle) / config.banks,
                     static_cast<double>(config.activate_to_activate_cycles),
                     config.four_activates_cycles / 4.0,
                     static_cast<double>(bursts * config.column_spacing()),
                     2.0 + bursts});
}

// Cycles a request, behind the first quarter.
double measured(const MemoryConfig& config, const Stream& stream) {
    constexpr std::uint32_t Count = 1200;
    constexpr std::uint64_t OldRow = ~std::uint64_t{0} - 1;
    const std::uint32_t before = stream.before;
    NobodyWatches nobody;
    DramChannel channel(config, 0, nobody);
    std::vector<MemoryCycle> end;
    std::uint32_t pushed = 0;
    for (MemoryCycle now = 0; end.size() < before + Count; ++now) {
        for (; channel.has_room(); ++pushed) {
            const std::uint32_t number = pushed - std::min(pushed, before);
            channel.push({.bank = number % config.banks,
                          .row = pushed < before ? OldRow : number / config.banks,
                          .bytes = stream.bursts * config.burst_bytes(),
                          .write = stream.write},
                         now);
        }
        channel.advance(now + 1);
        for (; !channel.served().empty(); channel.served().pop_front())
            end.push_back(channel.served().front().data.end);
    }
    return static_cast<double>(end[before + Count - 1] - end[before + Count / 4]) /
           (Count - 1 - Count / 4);
}

void check_profile(MemoryProfile profile, std::uint32_t banks, bool write) {
    MemoryConfig config;
    config.profile = profile;
    config.apply_profile();
    config.banks = banks;
    config.queue = 64;
    config.refresh_interval_cycles = 0;
    // What came before decides in which cycles the banks' commands meet.
    for (const std::uint32_t before : {0u, 1u, 2u, 5u, 20u, 33u}) {
        const Stream stream{.bursts = 1, .write = write, .before = before};
        INFO(MemoryProfileNames[static_cast<std::size_t>(profile)]
             << ", " << banks << " banks, " << (write ? "writes" : "reads") << " behind "
             << before);
        CHECK(measured(config, stream) == Approx(closed_form(config, stream)).epsilon(0.02));
    }
}

TEST_CASE("new rows take the closed form's time with the timings of each profile") {
    for (const MemoryProfile profile :
         {MemoryProfile::Sdr, MemoryProfile::Ddr, MemoryProfile::Gddr3}) {
        for (const std::uint32_t banks : {1u, 2u, 4u, 8u, 16u}) {
            check_profile(profile, banks, false);
            // Four requests in 14 cycles, 12 of them with a command: not found by who looks at one
            // cycle at a time.
            const bool needs_all_slots = profile == MemoryProfile::Ddr && banks == 4;
            if (!needs_all_slots) check_profile(profile, banks, true);
        }
    }
}

TEST_CASE(
    "new rows take the closed form's time within a hundredth over all timings, and never less") {
    Dice dice(21);
    const auto within = [&](std::uint32_t most) {
        return static_cast<std::uint32_t>(dice.below(most + 1));
    };
    constexpr int Count = 1000;
    double sum = 0;
    for (int i = 0; i < Count; ++i) {
        MemoryConfig config;
        config.queue = 64;
        config.refresh_interval_cycles = 0;
        config.banks = 1u << dice.below(4);
        config.burst_cycles = config.column_to_column_cycles = 1u << dice.below(3);
        const std::uint32_t bursts = std::max(1u, 1u << dice.below(4) >> 1);
        config.row_to_column_cycles = within(12);
        config.column_cycles = within(12);
        config.precharge_cycles = within(12);
        config.row_active_cycles = within(30);
        config.activate_to_activate_cycles = within(8);
        config.four_activates_cycles = dice.below(3) == 0 ? 1 + within(59) : 0;
        config.read_to_precharge_cycles = within(8);
        const Stream stream{.bursts = bursts};
        const double ratio = measured(config, stream) / closed_form(config, stream);
        INFO("timing " << i);
        CHECK(ratio > 0.99);
        sum += ratio;
    }
    CHECK(sum / Count < 1.01);
}

} // namespace
} // namespace ffgpu::timing
