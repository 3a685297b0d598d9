#include "model/gpu/page_set.h"

#include <random>
#include <set>

#include <catch2/catch.hpp>

using ffgpu::PageSet;

TEST_CASE("a page set overlaps exactly the pages that were added") {
    std::mt19937 random(8);
    for (int round = 0; round < 50; ++round) {
        PageSet set(std::uint64_t{1} << 22);
        std::set<std::uint64_t> pages;
        for (int i = 0; i < 6; ++i) {
            const std::uint64_t at = random() % ((1u << 22) - 1), most = (1u << 22) - at;
            const std::uint64_t bytes = random() % (round % 2 ? most : 9000) % most;
            set.add(at, bytes);
            for (std::uint64_t page = at >> 12; bytes > 0 && page <= (at + bytes - 1) >> 12; ++page)
                pages.insert(page);
        }
        for (std::uint64_t page = 0; page < 1024; ++page)
            REQUIRE(set.overlaps(page << 12, 4096) == pages.contains(page));
        for (int i = 0; i < 100; ++i) {
            const std::uint64_t at = random() % (1u << 21), bytes = random() % (1u << 20);
            const auto next = pages.lower_bound(at >> 12);
            const bool expected =
                bytes > 0 && next != pages.end() && *next <= (at + bytes - 1) >> 12;
            REQUIRE(set.overlaps(at, bytes) == expected);
        }
        set.clear();
        REQUIRE_FALSE(set.overlaps(0, 1u << 22));
    }
}
