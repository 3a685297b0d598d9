// What must not change a pixel, nor a cycle: threads, tiles, how commands are grouped, who listens.

#include "tests/system/trace_run.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr std::uint64_t LastFrame = 2;

// Own traces, and some of real programs: lists, arrays, feedback and selection, sphere maps,
// sprites.
std::vector<std::string> some_traces() {
    std::vector<std::string> paths;
    for (const std::string& name : own_traces())
        paths.push_back(own_trace(name));
    for (const std::string& name : workload_traces())
        for (const char* const wanted : {"busyspheres", "chromium", "openarena_dm", "polyhedra"})
            if (name == wanted) paths.push_back(workload_trace(name));
    return paths;
}

// The counters that differ, by name: what a failing test shows.
std::string differences(const Counters& a, const Counters& b) {
    std::string text;
    for (const auto& [name, value] : a) {
        const auto other = b.find(name);
        if (other == b.end()) {
            text += name + " is missing; ";
        } else if (other->second != value) {
            text += fmt::format("{}: {} and {}; ", name, value, other->second);
        }
    }
    return a.size() == b.size() ? text : text + "other counters";
}

TEST_CASE("Threads and tile sizes change neither pixels nor what was counted") {
    for (const std::string& path : some_traces()) {
        const Run plain = run_trace(path, {.last_frame = LastFrame});
        REQUIRE(plain.pictures.size() == LastFrame + 1);
        for (const unsigned tile_size : {16u, 32u, 64u, 128u}) {
            for (const unsigned threads : {1u, 2u, 3u}) {
                INFO(path << ", " << threads << " threads, tiles of " << tile_size);
                const Run run = run_trace(
                    path, {.threads = threads, .tile_size = tile_size, .last_frame = LastFrame});
                CHECK(run.pictures == plain.pictures);
                CHECK(differences(run.functional, plain.functional) == "");
            }
        }
    }
}

TEST_CASE("Recording the work of a whole trace changes neither pixels nor counters") {
    for (const std::string& path : some_traces()) {
        INFO(path);
        const Run plain = run_trace(path, {.threads = 2, .last_frame = LastFrame});
        const Run recorded =
            run_trace(path, {.threads = 2, .record_work = true, .last_frame = LastFrame});
        CHECK(recorded.pictures == plain.pictures);
        CHECK(differences(recorded.functional, plain.functional) == "");
    }
}

TEST_CASE("Draws one by one, and draws in two halves, give the same pixels as at once") {
    for (const std::string& path : some_traces()) {
        INFO(path);
        const Run plain = run_trace(path, {.last_frame = LastFrame});
        const Run one_by_one =
            run_trace(path, {.grouping = Grouping::OneByOne, .last_frame = LastFrame});
        CHECK(one_by_one.pictures == plain.pictures);
        CHECK(differences(one_by_one.functional, plain.functional) == "");
        CHECK(one_by_one.host.at("bins") >= plain.host.at("bins"));
        const Run halves = run_trace(path, {.grouping = Grouping::Halves, .last_frame = LastFrame});
        CHECK(halves.pictures == plain.pictures);
        CHECK(halves.functional.at("fragments_written") ==
              plain.functional.at("fragments_written"));
    }
}

// Bins of records hold a few primitives only: a draw is drawn in many.
constexpr std::size_t SmallBin = std::size_t{2} << 10;

void check_same_time(const std::string& path, const timing::TimingConfig& config) {
    const Run plain = run_trace(path, {.timing = config, .last_frame = 1});
    REQUIRE(plain.cycles.size() == 2);
    REQUIRE(plain.cycles.back() > 0);
    const RunOptions hosts[] = {{.threads = 3, .tile_size = 32},
                                {.threads = 1, .tile_size = 16},
                                {.threads = 2, .tile_size = 128},
                                {.threads = 2, .bin_bytes = SmallBin},
                                {.tile_size = 128, .bin_bytes = SmallBin}};
    for (RunOptions host : hosts) {
        INFO(path << ", " << host.threads << " threads, tiles of " << host.tile_size << ", bins of "
                  << host.bin_bytes);
        host.timing = config;
        host.last_frame = 1;
        const Run run = run_trace(path, host);
        CHECK(run.pictures == plain.pictures);
        CHECK(run.cycles == plain.cycles);
        CHECK(run.draw_cycles == plain.draw_cycles);
        CHECK(differences(run.timed, plain.timed) == "");
        CHECK(differences(run.functional, plain.functional) == "");
        if (host.bin_bytes == SmallBin) CHECK(run.host.at("bins") > plain.host.at("bins"));
    }
}

TEST_CASE("An immediate machine takes the same cycles however the host drew its work") {
    for (const std::string& path : some_traces())
        check_same_time(path, {});
}

TEST_CASE("A tile-based machine takes the same cycles however the host drew its work") {
    timing::TimingConfig tile_based;
    tile_based.raster.architecture = timing::Architecture::TileBased;
    for (const std::string& path : some_traces())
        check_same_time(path, tile_based);
}

} // namespace
} // namespace ffgpu::tools
