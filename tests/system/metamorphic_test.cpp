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

// Without the counters that describe how the host worked.
Counters machine_counters(const Run& run) {
    Counters counters = run.functional;
    for (const char* const host : {"bins", "batches", "tiles_visited"})
        REQUIRE(counters.erase(host) == 1);
    return counters;
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
                CHECK(differences(machine_counters(run), machine_counters(plain)) == "");
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
        CHECK(differences(machine_counters(recorded), machine_counters(plain)) == "");
    }
}

TEST_CASE("Draws one by one, and draws in two halves, give the same pixels as at once") {
    for (const std::string& path : some_traces()) {
        INFO(path);
        const Run plain = run_trace(path, {.last_frame = LastFrame});
        const Run one_by_one =
            run_trace(path, {.grouping = Grouping::OneByOne, .last_frame = LastFrame});
        CHECK(one_by_one.pictures == plain.pictures);
        CHECK(differences(machine_counters(one_by_one), machine_counters(plain)) == "");
        CHECK(one_by_one.functional.at("bins") >= plain.functional.at("bins"));
        const Run halves = run_trace(path, {.grouping = Grouping::Halves, .last_frame = LastFrame});
        CHECK(halves.pictures == plain.pictures);
        CHECK(halves.functional.at("fragments_written") ==
              plain.functional.at("fragments_written"));
    }
}

TEST_CASE("The machine takes the same cycles whatever threads and tiles drew its work") {
    for (const std::string& path : {own_trace("corridor"), own_trace("light_maps")}) {
        const Run plain = run_trace(path, {.timing = timing::TimingConfig{}, .last_frame = 1});
        REQUIRE(plain.cycles.size() == 2);
        REQUIRE(plain.cycles.back() > 0);
        CHECK(plain.pictures == run_trace(path, {.last_frame = 1}).pictures);
        for (const auto& [threads, tile_size] : {std::pair{3u, 64u}, {1u, 16u}, {2u, 128u}}) {
            INFO(path << ", " << threads << " threads, tiles of " << tile_size);
            const Run run = run_trace(path,
                                      {.threads = threads,
                                       .tile_size = tile_size,
                                       .timing = timing::TimingConfig{},
                                       .last_frame = 1});
            CHECK(run.cycles == plain.cycles);
            CHECK(run.draw_cycles == plain.draw_cycles);
            CHECK(differences(run.timed, plain.timed) == "");
        }
    }
}

} // namespace
} // namespace ffgpu::tools
