// A machine in time that goes on no more, from the command line, and settings that would make one.

#include "model/timing/machine_stuck.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"

#include <algorithm>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;

TEST_CASE("a stuck machine's report is told, and its exit status is 3") {
    int status = 0;
    const std::string told = printed(stderr, [&] {
        status = status_of([]() -> int { throw timing::MachineStuck("the report\nof each unit"); });
    });
    CHECK(status == timing::StuckStatus);
    CHECK(status == 3); // as the manual says
    CHECK_THAT(told, Contains("ffgpu: the report\nof each unit\n"));
}

// No settings may make a machine that goes on no more.
TEST_CASE("refreshes that leave no time to open, use and close a row are refused") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(3)));
    const auto status_with = [&](unsigned interval) {
        return run({"replay",
                    file.path(),
                    "-o",
                    folder / "out",
                    "--timing",
                    "--set",
                    "memory.refresh_cycles=1024",
                    "memory.refresh_interval_cycles=" + std::to_string(interval)});
    };
    // A row, with a write of 64 bytes on a bus of 8: tRCD, 4 bursts of 2 cycles, CL or WL, a
    // burst's data, tWR. tRP. tRFC. Another: tRRD or tFAW, tRCD, a turn of the bus, the data; and a
    // cycle each for refresh, activate, column and precharge.
    const unsigned data = 8 + 3 + 2;
    const unsigned least = (4 + data + 3) + 4 + 1024 + (3 + 4 + 3 + data) + 4;
    int status = 0;
    const std::string told = printed(stderr, [&] { status = status_with(least - 1); });
    CHECK(status == 2);
    CHECK_THAT(told,
               Contains("memory.refresh_interval_cycles: expected 0 or at least " +
                        std::to_string(least)));
    CHECK(status_with(1) == 2);
    CHECK(status_with(0) == 0);
    CHECK(status_with(least) == 0);
}

TEST_CASE("a memory that refreshes half of its time is slow, not stuck") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(1)));
    CHECK(run({"replay",
               file.path(),
               "-o",
               folder / "out",
               "--timing",
               "--set",
               "memory.refresh_interval_cycles=200",
               "memory.refresh_cycles=100"}) == 0);
}

} // namespace
} // namespace ffgpu::tools
