// ffgpu time: from a work file the machine in time tells what it told beside the drawing, byte for
// byte, on any configuration.

#include "tests/support/temporary_folder.h"
#include "tests/system/trace_run.h"
#include "tools/commands/command_line.h"
#include "tools/config/config_file.h"
#include "tools/replay/replay.h"
#include "tools/time/time_work.h"

#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace ffgpu::tools {
namespace {

std::string content(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

using Settings = std::vector<std::string>;
const Settings Immediate = {};
const Settings TileBased = {"raster.architecture=tile_based", "raster.bin_size=16"};
const Settings Narrow = {"texel_cache.ways=1", "texel_cache.layout=linear", "memory.channels=1"};

Configuration configured(const Settings& settings) {
    Configuration configuration;
    for (const std::string& setting : settings)
        apply_setting(setting, configuration);
    return configuration;
}

// stats.json of a replay; with `work` it keeps the work there.
std::string live(const std::string& trace, const Settings& settings, const std::string& work = "") {
    const TemporaryFolder folder;
    ReplayOptions options;
    options.input = trace;
    options.output = folder.path();
    options.save_work = work;
    options.configuration = configured(settings);
    options.frames = {1, 2};
    options.timing = true;
    options.images = false;
    replay(options);
    return content(folder / "stats.json");
}

std::string timed(const std::string& work, const Settings& settings) {
    const TemporaryFolder folder;
    time_work({work, folder.path(), configured(settings)});
    return content(folder / "stats.json");
}

std::vector<std::string> some_traces() {
    std::vector<std::string> paths;
    for (const std::string& name : own_traces())
        paths.push_back(own_trace(name));
    for (const std::string& name : workload_traces())
        if (name == "openarena_dm" || name == "chromium" || name == "polyhedra")
            paths.push_back(workload_trace(name));
    return paths;
}

TEST_CASE("From one file, each machine's statistics are those of its live run") {
    for (const std::string& trace : some_traces()) {
        INFO(trace);
        const TemporaryFolder folder;
        const std::string work = folder / "work.ffw";
        const std::string immediate = live(trace, Immediate, work);
        REQUIRE(nlohmann::json::parse(immediate)["frame_count"] == 2);
        CHECK(timed(work, Immediate) == immediate);
        const std::string tile_based = live(trace, TileBased);
        CHECK(tile_based != immediate);
        const auto functional = [](const std::string& statistics) {
            return nlohmann::json::parse(statistics)["totals"]["functional"];
        };
        CHECK(functional(tile_based) == functional(immediate));
        CHECK(timed(work, TileBased) == tile_based);
        CHECK(timed(work, Narrow) == live(trace, Narrow));
    }
}

// The file that frames 0 and 1 of `trace` leave with these options.
std::string work_of(const std::string& trace, unsigned threads, unsigned tile_size, bool timing) {
    const TemporaryFolder folder;
    ReplayOptions options;
    options.input = trace;
    options.save_work = folder / "work.ffw";
    options.frames = {0, 1};
    options.timing = timing;
    options.configuration.gpu.threads = threads;
    options.configuration.gpu.tile_size = tile_size;
    replay(options);
    return content(options.save_work);
}

TEST_CASE("The file's bytes do not depend on threads, tiles, or whether time is taken") {
    for (const std::string& trace : some_traces()) {
        INFO(trace);
        const std::string plain = work_of(trace, 1, 64, false);
        REQUIRE(plain.size() > 1000);
        CHECK(work_of(trace, 3, 16, false) == plain);
        CHECK(work_of(trace, 2, 128, true) == plain);
    }
}

int run(const std::vector<std::string>& arguments) {
    std::vector<const char*> pointers{"ffgpu"};
    for (const std::string& argument : arguments)
        pointers.push_back(argument.c_str());
    return run_command_line(static_cast<int>(pointers.size()), pointers.data(), "test");
}

TEST_CASE("A damaged work file gives exit status 2, and keeps the frames before the damage") {
    const TemporaryFolder folder;
    const std::string work = folder / "work.ffw", damaged = folder / "damaged.ffw";
    const std::string out = folder / "out";
    // Frames of more than a block, so that some are whole before the file's end.
    REQUIRE(run({"replay", own_trace("corridor"), "--save-work", work}) == 0);
    const std::string bytes = content(work);
    REQUIRE(run({"time", work, "-o", out}) == 0);
    const auto whole = nlohmann::json::parse(content(out + "/stats.json"));
    REQUIRE(whole["frame_count"] == 8);

    write(damaged, bytes.substr(0, bytes.size() - 100));
    CHECK(run({"time", damaged, "-o", out}) == 2);
    const auto kept = nlohmann::json::parse(content(out + "/stats.json"));
    REQUIRE(kept["frame_count"].get<std::size_t>() > 0);
    CHECK(kept["frames"][0] == whole["frames"][0]);

    std::string newer = bytes;
    newer[8] = 9;
    write(damaged, newer);
    CHECK(run({"time", damaged, "-o", out}) == 2);
    CHECK(run({"time", folder / "missing.ffw", "-o", out}) == 2);
    CHECK(run({"time", work}) == 2);
    CHECK(run({"time", work, "-o", out, "--set", "texel_cache.wayz=1"}) == 2);
    CHECK(run({"replay", own_trace("corridor"), "--save-work", folder / "no/such.ffw"}) == 2);
}

} // namespace
} // namespace ffgpu::tools
