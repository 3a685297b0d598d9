// Optimal replacement told as the look-ups come, against replay with the look-ups to come, against
// every other policy, and against a search of all choices.

#include "model/work/line_replay.h"
#include "model/work/optimal_tags.h"
#include "tests/work/fewest_misses.h"

#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

std::uint64_t misses_online(const Trace& trace,
                            std::uint32_t sets,
                            std::uint32_t ways,
                            IndexHash hash = IndexHash::Modulo) {
    OptimalTags tags(sets, ways, hash);
    std::uint64_t misses = 0;
    for (std::size_t i = 0; i < trace.size(); ++i) {
        if (tags.find(trace[i])) {
            tags.use(trace[i]);
        } else {
            tags.replace(trace[i], i);
            ++misses;
        }
    }
    return misses;
}

TEST_CASE("the textbook's reference string has 9 faults at best, told as it comes") {
    // A. Silberschatz, P. Galvin, G. Gagne, Operating System Concepts, page replacement: 3 frames.
    CHECK(misses_online({7, 0, 1, 2, 0, 3, 0, 4, 2, 3, 0, 3, 2, 1, 2, 0, 1, 7, 0, 1}, 1, 3) == 9);
}

TEST_CASE("optimal replacement, as the look-ups come, is what a search of all choices finds") {
    std::mt19937 random(3);
    for (int i = 0; i < 300; ++i) {
        Trace trace(14);
        for (std::uint64_t& line : trace)
            line = random() % 6;
        const auto ways = static_cast<unsigned>(1 + random() % 4);
        CHECK(misses_online(trace, 1, ways) == fewest(trace, 0, {}, ways));
    }
}

TEST_CASE("optimal replacement never misses more than another policy, on random look-ups") {
    std::mt19937 random(11);
    for (int i = 0; i < 2000; ++i) {
        const std::uint32_t sets = 1u << random() % 4;
        const auto ways = static_cast<std::uint32_t>(1 + random() % 8);
        const IndexHash hash = random() % 2 ? IndexHash::Xor : IndexHash::Modulo;
        const std::uint64_t lines = 1 + random() % 100;
        Trace trace(random() % 600);
        for (std::size_t at = 0; at < trace.size(); ++at) // Strides, and lines by lot.
            trace[at] = random() % 3 == 0 ? random() % lines : at * 3 % lines;
        const std::uint64_t best = misses_online(trace, sets, ways, hash);
        const auto with = [&](Replacement replacement) {
            return count_misses(trace, sets, ways, {replacement, 5, hash});
        };
        CHECK(best == with(Replacement::Optimal));
        for (const Replacement other : {Replacement::Lru, Replacement::Fifo, Replacement::Random})
            CHECK(best <= with(other));
    }
}

TEST_CASE("a line that is found tells the fill that brought it") {
    OptimalTags tags(1, 2, IndexHash::Modulo);
    CHECK(tags.find(4) == nullptr);
    tags.replace(4, 17);
    tags.replace(5, 18);
    REQUIRE(tags.find(4) != nullptr);
    CHECK(*tags.find(4) == 17);
    tags.use(4);
    tags.clear();
    CHECK(tags.find(4) == nullptr);
}

} // namespace
} // namespace ffgpu::work
