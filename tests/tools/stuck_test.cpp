// A machine in time that goes on no more, from the command line. A memory that has to refresh again
// before a refresh is over serves nobody, ever: a deadlock that settings alone can make.

#include "model/timing/machine_stuck.h"
#include "tests/support/temporary_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/tools/tool.h"

#include <cstdlib>

#include <catch2/catch.hpp>

namespace ffgpu::tools {
namespace {

using Catch::Matchers::Contains;

const std::vector<std::string> Starving{
    "--set", "memory.refresh_interval_cycles=1", "memory.refresh_cycles=1024"};

struct Run {
    int status = 0;
    std::string report;
};

Run run_starving(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), Starving.begin(), Starving.end());
    Run result;
    result.report = printed(stderr, [&] { result.status = run(arguments); });
    return result;
}

// The number behind a part of the report.
std::uint64_t number_behind(const std::string& report, const std::string& part) {
    const std::size_t at = report.find(part);
    REQUIRE(at != std::string::npos);
    return std::strtoull(report.c_str() + at + part.size(), nullptr, 10);
}

void check_report(const std::string& report) {
    INFO(report);
    CHECK_THAT(report, Contains("the timed machine is stuck in cycle "));
    CHECK_THAT(report, Contains("culprit: memory\n"));
    CHECK_THAT(report, Contains("arbiter waits for memory"));
    for (const char* const unit : {"host",
                                   "command_processor",
                                   "vertex_fetch",
                                   "geometry",
                                   "clip",
                                   "setup",
                                   "raster",
                                   "depth",
                                   "texture",
                                   "fragment",
                                   "color",
                                   "scan_out",
                                   "arbiter",
                                   "memory"})
        CHECK_THAT(report, Contains("\n  " + std::string(unit) + ": "));
    // The memory stands since its first refresh, long before a million cycles made it sure.
    CHECK(number_behind(report, "stuck in cycle ") >= 1'000'000);
    CHECK(number_behind(report, "\n  memory: stalled_memory since cycle ") < 10'000);
}

TEST_CASE("a stuck machine ends with exit status 3 and each unit's state, where nothing answers") {
    const TemporaryFolder folder;
    const TemporaryFile file(trace::in_snappy(clears(3)));
    const Run replayed = run_starving({"replay", file.path(), "-o", folder / "out", "--timing"});
    CHECK(replayed.status == timing::StuckStatus);
    CHECK(replayed.status == 3); // as the manual says
    check_report(replayed.report);

    REQUIRE(run({"replay", file.path(), "--save-work", folder / "saved.work"}) == 0);
    const Run timed = run_starving({"time", folder / "saved.work", "-o", folder / "time"});
    CHECK(timed.status == 3);
    check_report(timed.report);
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
