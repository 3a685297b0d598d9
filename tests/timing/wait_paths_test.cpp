// Paths of what was waited for: those of hand-made chains, whose lengths have closed forms, and
// any paths against plain lists of what was waited for in each cycle.

#include "model/timing/wait_paths.h"
#include "tests/timing/random_work.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

constexpr Resource A = Resource::Setup, B = Resource::Raster, C = Resource::Color;

// Cycles of each resource along the path of a frame that began after cycle `begin`.
WaitedCycles cycles_of(const WaitPaths& paths, WaitPaths::Path path, Cycle begin = 0) {
    WaitedCycles cycles{};
    for (const WaitPaths::Run& run : paths.runs(path)) {
        REQUIRE(run.end > begin);
        cycles[static_cast<std::size_t>(run.resource)] += run.end - begin;
        begin = run.end;
    }
    CHECK(begin == paths.end(path));
    return cycles;
}

Cycle waited(const WaitedCycles& cycles, Resource resource) {
    return cycles[static_cast<std::size_t>(resource)];
}

TEST_CASE("a path that alternates waits n times each wait") {
    WaitPaths paths;
    const Cycle begin = 70, rounds = GENERATE(as<Cycle>(), 1, 2, 1000);
    WaitPaths::Path path = paths.restart(begin);
    for (Cycle i = 0; i < rounds; ++i) {
        path = paths.extend(path, A, begin + 8 * i + 3);
        path = paths.extend(path, B, begin + 8 * i + 7);
        path = paths.extend(path, B, begin + 8 * i + 8); // goes on
    }
    const WaitedCycles cycles = cycles_of(paths, path, begin);
    CHECK(waited(cycles, A) == 3 * rounds);
    CHECK(waited(cycles, B) == 5 * rounds);
    CHECK(paths.runs(path).size() == 2 * rounds);
}

TEST_CASE("no cycle is waited twice: a path that is there already stays") {
    WaitPaths paths;
    WaitPaths::Path path = paths.extend(paths.restart(0), A, 9);
    path = paths.extend(path, B, 9);
    path = paths.extend(path, C, 4);
    CHECK(waited(cycles_of(paths, path), A) == 9);
}

TEST_CASE("ways that part after a common past each keep their own") {
    WaitPaths paths;
    const WaitPaths::Path past = paths.share(paths.extend(paths.restart(0), A, 10));
    const WaitPaths::Path one = paths.extend(past, A, 14); // by what the past ends with, too
    const WaitPaths::Path other = paths.extend(past, B, 17);
    CHECK(waited(cycles_of(paths, past), A) == 10);
    CHECK(waited(cycles_of(paths, one), A) == 14);
    CHECK(waited(cycles_of(paths, other), A) == 10);
    CHECK(waited(cycles_of(paths, other), B) == 7);
}

TEST_CASE("what goes on by the resource that a common past ends with is one run") {
    WaitPaths paths;
    WaitPaths::Path path = paths.share(paths.extend(paths.restart(5), B, 8));
    for (Cycle end = 9; end <= 40; ++end)
        path = paths.share(paths.extend(path, A, end));
    const std::vector<WaitPaths::Run> runs = paths.runs(path);
    REQUIRE(runs.size() == 2);
    CHECK(runs[0].end == 8);
    CHECK(runs[1].end == 40);
    CHECK(waited(cycles_of(paths, path, 5), A) == 32);
}

// Three stages in a row, of which each takes an item when the one before it is done with it and it
// is done with the item before: the slowest works on all items, the others on one.
TEST_CASE("along the critical path of a chain the slowest works on all items, the others on one") {
    constexpr std::array<Resource, 3> Stages{A, B, C};
    const std::array<Cycle, 3> takes = GENERATE(std::array<Cycle, 3>{3, 5, 8},
                                                std::array<Cycle, 3>{8, 5, 3},
                                                std::array<Cycle, 3>{3, 8, 5});
    constexpr Cycle Items = 50;
    WaitPaths paths;
    std::array<WaitPaths::Path, 3> done{};
    done.fill(paths.restart(0));
    for (Cycle item = 0; item < Items; ++item) {
        WaitPaths::Path sent = 0; // All items are there at the start.
        for (std::size_t stage = 0; stage < 3; ++stage) {
            const bool waited_for = paths.end(sent) > paths.end(done[stage]);
            WaitPaths::Path& path = done[stage];
            if (waited_for) path = paths.share(sent);
            path = sent = paths.extend(path, Stages[stage], paths.end(path) + takes[stage]);
        }
    }
    const auto slowest =
        static_cast<std::size_t>(std::max_element(takes.begin(), takes.end()) - takes.begin());
    const WaitedCycles cycles = cycles_of(paths, done[2]);
    for (std::size_t stage = 0; stage < 3; ++stage)
        CHECK(waited(cycles, Stages[stage]) == takes[stage] * (stage == slowest ? Items : 1));
}

// --- Against plain lists ------------------------------------------------------------------------

struct PlainPath {
    std::vector<Resource> waited; // in each cycle
    WaitPaths::Path path = 0;
};

void compare(const WaitPaths& paths, const PlainPath& plain, Cycle begin) {
    std::vector<Resource> waited;
    for (const WaitPaths::Run& run : paths.runs(plain.path))
        waited.resize(run.end - begin, run.resource);
    CHECK(waited == plain.waited);
}

TEST_CASE("any paths are those of plain lists, and what nobody goes through is forgotten") {
    constexpr std::size_t Most = 64;
    constexpr Cycle Begin = 1000;
    constexpr unsigned Checked = 500;
    std::size_t most_runs = 0;
    RandomWork random(3);
    WaitPaths paths(Most);
    std::array<PlainPath, 5> all{};
    std::vector<WaitPaths::Path*> kept;
    for (PlainPath& each : all) {
        each.path = paths.restart(Begin);
        kept.push_back(&each.path);
    }
    for (unsigned step = 0; step < 20'000; ++step) {
        PlainPath& path = all[random.below(5)];
        const PlainPath& other = all[random.below(5)];
        if (random.below(3) == 0) {
            path.path = paths.share(other.path);
            path.waited = other.waited;
        } else {
            const auto resource = static_cast<Resource>(random.below(4));
            path.waited.resize(path.waited.size() + 1 + random.below(2), resource);
            path.path = paths.extend(path.path, resource, Begin + path.waited.size());
        }
        if (paths.is_full()) paths.collect(kept);
        if (step % Checked != 0) continue;
        std::size_t runs = 0;
        for (const PlainPath& each : all) {
            compare(paths, each, Begin);
            runs += paths.runs(each.path).size();
        }
        most_runs = std::max(most_runs, runs);
    }
    CHECK(paths.nodes() <= 2 * (most_runs + Checked)); // of about 13,000 that there were
}

} // namespace
} // namespace ffgpu::timing
