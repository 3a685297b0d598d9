// Between two refreshes that are allowed there is always time to serve a request.

#include "model/base/input_error.h"
#include "model/timing/gpu_timing.h"
#include "tests/timing/random_work.h"

#include <regex>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

// Timings by lot, around and beyond those of real memories.
TimingConfig machine(RandomWork& random) {
    TimingConfig config;
    MemoryConfig& memory = config.memory;
    memory.refresh_cycles = 5 + random.below(56);
    memory.row_to_column_cycles = random.below(41);
    memory.precharge_cycles = random.below(41);
    memory.row_active_cycles = random.below(121);
    memory.column_cycles = random.below(41);
    memory.write_column_cycles = random.below(41);
    memory.write_recovery_cycles = random.below(21);
    memory.write_to_read_cycles = random.below(21);
    memory.read_to_write_cycles = random.below(21);
    memory.four_activates_cycles = random.below(81);
    memory.burst_cycles = random.power(4);
    return config;
}

// What is told to be enough where an interval of a cycle is asked for.
std::uint32_t enough(TimingConfig config) {
    config.memory.refresh_interval_cycles = 1;
    try {
        const GpuTiming timing(config);
    } catch (const InputError& error) {
        std::smatch match;
        const std::string told = error.what();
        REQUIRE(std::regex_search(told, match, std::regex("expected 0 or at least ([0-9]+)")));
        return static_cast<std::uint32_t>(std::stoul(match[1]));
    }
    FAIL("an interval of a cycle was accepted");
    return 0;
}

} // namespace

TEST_CASE("a refresh interval that is accepted ends, whatever the timings") {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        INFO("seed " << seed);
        RandomWork random(seed);
        TimingConfig config = machine(random);
        const auto frame = random.frame(2);
        config.memory.refresh_interval_cycles = enough(config) + random.below(8);
        GpuTiming timing(config);
        for (const auto& command : frame)
            timing.command(command);
        CHECK_NOTHROW(timing.end_frame(0));
    }
}

} // namespace ffgpu::timing
