// Kinds of misses by a log against a classifier that is told at once.

#include "model/timing/miss_kinds.h"
#include "model/work/texel_line.h"

#include <random>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

TEST_CASE("misses that are reckoned many at a time are of the kinds that they were") {
    struct Shape {
        std::uint32_t sets, ways;
        unsigned kinds; // of misses that there can be
    };
    // The shadow has fewer lines than are kept beside it, as many, and more.
    const auto [Sets, Ways, Kinds] =
        GENERATE(Shape{4, 2, 3}, Shape{2, 2, 3}, Shape{1, 4, 2}, Shape{2, 1, 3}, Shape{16, 1, 3});
    std::mt19937 random(11);
    const auto below = [&](std::uint64_t n) { return random() % n; };
    CacheStatistics told("told");
    MissKinds kinds(Sets, Ways, told);
    work::MissClassifier at_once(Sets, Ways);
    std::uint64_t by_kind[3] = {}, beyond_shadow = 0;
    const auto compare = [&] {
        kinds.settle();
        REQUIRE(told.compulsory.value() == by_kind[0]);
        REQUIRE(told.capacity.value() == by_kind[1]);
        REQUIRE(told.conflict.value() == by_kind[2]);
        REQUIRE(told.beyond_shadow.value() == beyond_shadow);
    };
    constexpr std::uint64_t Expanded = std::uint64_t{4} << work::ExpansionAt;
    for (int i = 0; i < 50'000; ++i) {
        // Most are of a few lines that change slowly.
        const std::uint64_t near = static_cast<std::uint64_t>(i) / 40 + below(3);
        const std::uint64_t number = below(3) == 0 ? below(30) : near % 30;
        const std::uint64_t line = number | (below(4) == 0 ? Expanded : 0);
        if (below(500) == 0) {
            kinds.flush();
            at_once.flush();
        } else if (below(20) == 0) {
            kinds.drop(line);
            at_once.drop(line);
        } else {
            const bool missed = below(3) == 0;
            kinds.look_up(line, missed);
            const auto kind = static_cast<std::size_t>(at_once.access(line));
            by_kind[kind] += missed;
            beyond_shadow += !missed && at_once.shadow_missed();
        }
        if (below(3000) == 0) compare();
    }
    compare();
    for (unsigned kind = 0; kind < Kinds; ++kind)
        CHECK(by_kind[kind] > 0);
    CHECK(beyond_shadow > 0);
    CHECK(told.hits.value() + told.misses.value() == 0); // who looks up counts these
}

} // namespace
} // namespace ffgpu::timing
