// One client's requests over several channels, and the commands of several banks in one cycle:
// against the bytes that the buses can carry, and the closed form of new rows.

#include "tests/timing/memory_bench.h"

#include <algorithm>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

MemoryConfig without_refresh(std::uint32_t channels) {
    MemoryConfig config;
    config.refresh_interval_cycles = 0;
    config.channels = channels;
    config.queue = 64;
    config.client_queue = 1024;
    return config;
}

TEST_CASE("a client's stream of row hits fills the buses of all channels") {
    for (const std::uint32_t channels : {1u, 2u, 4u, 8u, 16u}) {
        for (const std::uint32_t interleave : {64u, 256u, 1024u}) {
            for (const std::uint32_t width : {8u, 32u}) {
                MemoryConfig config = without_refresh(channels);
                config.interleave_bytes = interleave;
                config.bytes_per_cycle = width;
                constexpr std::size_t Lines = 40000;
                const double peak = 64.0 * Lines / (channels * width);
                INFO(channels << " channels, interleave " << interleave << ", width " << width);
                const BenchResult result = run_memory(config, line_stream(Lines));
                CHECK(static_cast<double>(result.steady_cycles()) < peak / 0.95);
                CHECK(static_cast<double>(result.cycles) >= peak);
            }
        }
    }
}

TEST_CASE("a client sends no more requests in a cycle than there are channels") {
    MemoryConfig config = without_refresh(4);
    config.profile = MemoryProfile::Ideal;
    config.apply_profile();
    config.bytes_per_cycle = 64;
    config.interleave_bytes = 64;
    constexpr std::size_t Lines = 4000;
    CHECK(run_memory(config, line_stream(Lines)).cycles >= Lines / 4);
}

// A bank takes max(tRAS, tRCD + tRTP) + tRP a row.
TEST_CASE("where two banks take longer than the closed form their commands met") {
    struct Case {
        std::uint32_t banks, row_to_column, precharge, active, between_activates, to_precharge;
    };
    for (const Case& each : {Case{1, 3, 3, 6, 2, 4},
                             Case{2, 3, 3, 6, 2, 4},
                             Case{2, 4, 4, 8, 3, 2},
                             Case{2, 2, 14, 20, 9, 11},
                             Case{2, 8, 9, 14, 5, 2}}) {
        MemoryConfig config = without_refresh(1);
        config.banks = each.banks;
        config.row_to_column_cycles = each.row_to_column;
        config.precharge_cycles = each.precharge;
        config.row_active_cycles = each.active;
        config.activate_to_activate_cycles = each.between_activates;
        config.read_to_precharge_cycles = each.to_precharge;
        constexpr std::size_t Count = 6000;
        std::vector<MemoryRequest> list;
        for (std::size_t i = 0; i < Count; ++i)
            list.push_back(
                {.address = i * config.row_bytes, .bytes = 16, .client = Client::Texture});
        const BenchResult result = run_memory(config, list);
        const double row_cycle =
            std::max(each.active, each.row_to_column + each.to_precharge) + each.precharge;
        const double form = std::max({row_cycle / each.banks,
                                      double(each.between_activates),
                                      double(config.burst_cycles),
                                      3.0 /* commands */});
        const double beyond = static_cast<double>(result.steady_cycles()) - form * (Count - 1);
        const auto taken = static_cast<double>(result.figures.at("memory_lost_commands_cycles"));
        INFO(each.banks << " banks, tRCD " << each.row_to_column << ": " << beyond << " beyond, "
                        << taken << " lost to commands");
        CHECK(beyond <= taken + 0.02 * form * Count);
        if (each.banks == 1) CHECK(taken == 0);
    }
}

} // namespace
} // namespace ffgpu::timing
