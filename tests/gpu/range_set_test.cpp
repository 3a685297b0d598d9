#include "model/gpu/range_set.h"

#include <bitset>
#include <random>

#include <catch2/catch.hpp>

using ffgpu::RangeSet;

TEST_CASE("a range set overlaps exactly the bytes that were added and not removed") {
    constexpr std::size_t Memory = 4096;
    std::mt19937 random(8);
    for (int round = 0; round < 200; ++round) {
        RangeSet set;
        std::bitset<Memory> bytes;
        const std::uint32_t most = round % 2 ? 40 : 400;
        for (int i = 0; i < 20; ++i) {
            const std::size_t count = random() % most, at = random() % (Memory - count);
            const bool removes = i % 3 == 2;
            removes ? set.remove(at, count) : set.add(at, count);
            for (std::size_t byte = at; byte < at + count; ++byte)
                bytes.set(byte, !removes);
        }
        REQUIRE(set.empty() == bytes.none());
        for (std::size_t byte = 0; byte < Memory; ++byte)
            REQUIRE(set.overlaps(byte, 1) == bytes.test(byte));
        for (int i = 0; i < 200; ++i) {
            const std::size_t count = random() % 100, at = random() % (Memory - count);
            bool expected = false;
            for (std::size_t byte = at; byte < at + count; ++byte)
                expected = expected || bytes.test(byte);
            REQUIRE(set.overlaps(at, count) == expected);
        }
        set.clear();
        REQUIRE_FALSE(set.overlaps(0, Memory));
    }
}

TEST_CASE("ranges that meet do not overlap") {
    RangeSet set;
    set.add(100, 50);
    CHECK_FALSE(set.overlaps(0, 100));
    CHECK(set.overlaps(0, 101));
    CHECK(set.overlaps(149, 1));
    CHECK_FALSE(set.overlaps(150, 10));
    CHECK_FALSE(set.overlaps(120, 0));
}
