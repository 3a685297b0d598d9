// ffgpu time --measure-gains: against runs whose limits are taken away by hand, with settings.

#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tools/commands/command_line.h"
#include "tools/replay/interruption.h"
#include "tools/time/measured_gains.h"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

using Arguments = std::vector<std::string>;

int run(const Arguments& arguments) {
    std::vector<const char*> pointers{"ffgpu"};
    for (const std::string& argument : arguments)
        pointers.push_back(argument.c_str());
    return run_command_line(static_cast<int>(pointers.size()), pointers.data(), "test");
}

// Cycles of each frame, from stats.json.
std::vector<std::uint64_t>
frame_cycles(const std::string& work, const std::string& out, const Arguments& settings) {
    Arguments arguments{"time", work, "-o", out};
    for (const std::string& setting : settings)
        arguments.insert(arguments.end(), {"--set", setting});
    REQUIRE(run(arguments) == 0);
    std::ifstream file(out + "/stats.json");
    const nlohmann::json statistics = nlohmann::json::parse(file);
    std::vector<std::uint64_t> cycles;
    for (const auto& frame : statistics["frames"])
        cycles.push_back(frame["timing"]["total_cycles"]);
    return cycles;
}

struct Row {
    std::uint64_t cycles = 0, without = 0;
    std::int64_t gain = 0, reckoned = 0;
};

// gains.csv by frame and resource.
std::map<std::pair<int, std::string>, Row> gains(const std::string& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    CHECK(line == "frame,resource,cycles,cycles_without,gain,reckoned_gain");
    std::map<std::pair<int, std::string>, Row> rows;
    while (std::getline(file, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        int frame = 0;
        std::string resource;
        Row row;
        words >> frame >> resource >> row.cycles >> row.without >> row.gain >> row.reckoned;
        rows[{frame, resource}] = row;
    }
    return rows;
}

TEST_CASE("Measured gains are those of machines whose limits are taken away by hand") {
    const TemporaryFolder folder;
    const std::string work = folder / "work.ffw", out = folder / "out";
    REQUIRE(run({"replay", own_trace("corridor"), "--save-work", work, "--frames", "1-2"}) == 0);
    const Arguments slow{"fragment.quad_cycles=24", "host.bytes_per_cycle=4"};
    Arguments measured{"time", work, "-o", out, "--measure-gains"};
    for (const std::string& setting : slow)
        measured.insert(measured.end(), {"--set", setting});
    REQUIRE(run(measured) == 0);
    const auto rows = gains(out + "/gains.csv");

    const std::vector<std::uint64_t> base = frame_cycles(work, folder / "base", slow);
    const auto by_hand = [&](const std::string& resource, const Arguments& without) {
        Arguments settings = slow;
        settings.insert(settings.end(), without.begin(), without.end());
        const std::vector<std::uint64_t> cycles = frame_cycles(work, folder / resource, settings);
        for (std::size_t i = 0; i < base.size(); ++i) {
            INFO(resource << ", frame " << i + 1);
            const Row& row = rows.at({static_cast<int>(i) + 1, resource});
            CHECK(row.cycles == base[i]);
            CHECK(row.without == cycles[i]);
            CHECK(row.gain ==
                  static_cast<std::int64_t>(base[i]) - static_cast<std::int64_t>(cycles[i]));
        }
    };
    REQUIRE(base.size() == 2);
    by_hand("fragment",
            {"fragment.quad_cycles=1", "fragment.combiner_cycles=1", "fragment.combiners=8"});
    by_hand("host", {"host.bytes_per_cycle=0"});
    by_hand("clip", {"clip.plane_cycles=0"});
    for (const auto& [key, row] : rows)
        CHECK(row.gain <= rows.at({key.first, "fragment"}).gain);
    CHECK(rows.count({1, "binner"}) == 0); // An immediate machine has none.
    CHECK(run({"time", work, "--totals", folder / "t.json", "--measure-gains"}) == 2);
}

TEST_CASE("Ctrl-C while gains are measured leaves none, not those of an older run either") {
    const TemporaryFolder folder;
    const std::string work = folder / "work.ffw", out = folder / "out";
    REQUIRE(run({"replay", own_trace("corridor"), "--save-work", work, "--frames", "1-2"}) == 0);
    const timing::TimingConfig config;
    {
        const Interruption interruption;
        std::raise(SIGINT);
        CHECK(measure_gains(work, config).empty());
    }
    REQUIRE(run({"time", work, "-o", out, "--measure-gains"}) == 0);
    CHECK(std::filesystem::exists(out + "/gains.csv"));
    REQUIRE(run({"time", work, "-o", out}) == 0);
    CHECK_FALSE(std::filesystem::exists(out + "/gains.csv"));
}

} // namespace
} // namespace ffgpu::tools
