// New rows over B banks in turn, by one channel: against the closed form of docs/units/memory.md.
// It asks that the commands of all banks find cycles of their own, which not all timings allow.

#include "tests/timing/memory_bench.h"
#include "tests/timing/nobody_watches.h"

#include <algorithm>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// An activate, a column and a precharge of a bank take a cycle each, whatever the timings.
double closed_form(const MemoryConfig& config, std::uint32_t bursts) {
    const auto at_least_one = [](std::uint32_t cycles) { return std::max(cycles, 1u); };
    const std::uint32_t columns = (bursts - 1) * config.column_spacing();
    const std::uint32_t row_cycle = std::max(config.row_active_cycles,
                                             at_least_one(config.row_to_column_cycles) + columns +
                                                 at_least_one(config.read_to_precharge_cycles)) +
                                    at_least_one(config.precharge_cycles);
    return std::max({static_cast<double>(row_cycle) / config.banks,
                     static_cast<double>(config.activate_to_activate_cycles),
                     config.four_activates_cycles / 4.0,
                     static_cast<double>(bursts * config.column_spacing()),
                     2.0 + bursts});
}

// Cycles a request, behind the first quarter.
double measured(const MemoryConfig& config, std::uint32_t bursts) {
    constexpr std::uint32_t Count = 1200;
    NobodyWatches nobody;
    DramChannel channel(config, 0, nobody);
    std::vector<MemoryCycle> end;
    std::uint32_t pushed = 0;
    for (MemoryCycle now = 0; end.size() < Count; ++now) {
        for (; channel.has_room(); ++pushed)
            channel.push({.bank = pushed % config.banks,
                          .row = pushed / config.banks,
                          .bytes = bursts * config.burst_bytes()},
                         now);
        channel.advance(now + 1);
        for (; !channel.served().empty(); channel.served().pop_front())
            end.push_back(channel.served().front().data.end);
    }
    return static_cast<double>(end[Count - 1] - end[Count / 4]) / (Count - 1 - Count / 4);
}

TEST_CASE("new rows take the closed form's time with the timings of each profile") {
    for (const MemoryProfile profile :
         {MemoryProfile::Sdr, MemoryProfile::Ddr, MemoryProfile::Gddr3}) {
        for (const std::uint32_t banks : {1u, 2u, 4u, 8u, 16u}) {
            MemoryConfig config;
            config.profile = profile;
            config.apply_profile();
            config.banks = banks;
            config.queue = 64;
            config.refresh_interval_cycles = 0;
            INFO(MemoryProfileNames[static_cast<std::size_t>(profile)] << ", " << banks
                                                                       << " banks");
            CHECK(measured(config, 1) == Approx(closed_form(config, 1)).epsilon(0.02));
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
        const double ratio = measured(config, bursts) / closed_form(config, bursts);
        INFO("timing " << i);
        CHECK(ratio > 0.99);
        sum += ratio;
    }
    CHECK(sum / Count < 1.01);
}

} // namespace
} // namespace ffgpu::timing
