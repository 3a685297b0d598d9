// The newest lines against a list of them.

#include "model/work/recent_lines.h"

#include <algorithm>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// Lines that share many low bits, few, and only the upper half of their numbers.
std::uint64_t any_line(std::mt19937& random) {
    const std::uint64_t number = random() % 12;
    switch (random() % 3) {
    case 0:
        return number;
    case 1:
        return number << 6;
    default:
        return number << 31 | (random() % 2);
    }
}

// Of 2^(level + 1) sets, those of the lines up to `end` that share the line's.
std::size_t sharers_of(std::uint64_t line,
                       std::size_t level,
                       std::vector<std::uint64_t>::const_iterator first,
                       std::vector<std::uint64_t>::const_iterator end) {
    const std::uint64_t set = (std::uint64_t{2} << level) - 1;
    return static_cast<std::size_t>(std::count_if(
        first, end, [&](std::uint64_t other) { return ((other ^ line) & set) == 0; }));
}

} // namespace

TEST_CASE("the newest lines are where a list of them says", "[curves]") {
    for (const std::size_t levels : {0u, 1u, 5u, 16u}) {
        INFO(levels << " numbers of sets");
        std::mt19937 random(20);
        RecentLines lines(levels);
        std::vector<std::uint64_t> list; // the newest first
        std::size_t found_lines = 0;
        for (std::uint64_t i = 0; i < 20000; ++i) {
            const std::uint64_t line = any_line(random);
            REQUIRE(lines.has(line) == (std::count(list.begin(), list.end(), line) > 0));
            const auto at = std::find(list.begin(), list.end(), line);
            const RecentLines::Found found = lines.use(line);
            if (at != list.end()) {
                ++found_lines;
                REQUIRE(found.depth == static_cast<std::size_t>(at - list.begin()));
                for (std::size_t level = 0; level < RecentLines::MostLevels; ++level)
                    REQUIRE((found.sharers >> 4 * level & 15) ==
                            (level < levels ? sharers_of(line, level, list.begin(), at) : 0));
                REQUIRE(lines.newest().line == line);
                list.erase(at);
            } else {
                REQUIRE(found.depth == RecentLines::Most);
                if (list.size() == RecentLines::Most) {
                    REQUIRE(lines.newest().line == list.back()); // which leaves
                    list.pop_back();
                } else {
                    REQUIRE(lines.newest().left == RecentLines::Unused);
                }
                lines.newest() = {.line = line, .place = i, .left = 0, .id = 0};
            }
            list.insert(list.begin(), line);
            REQUIRE(lines.size() == list.size());
            if (random() % 200 != 0) continue;
            lines.all_leave([&](const RecentLines::Use& use) {
                REQUIRE(use.line == list.back());
                list.pop_back();
            });
            REQUIRE(list.empty());
        }
        CHECK(found_lines > 1000);
    }
}

TEST_CASE("all fifteen newer lines count in every set", "[curves]") {
    RecentLines lines(RecentLines::MostLevels);
    for (std::uint64_t line = 0; line < RecentLines::Most; ++line) {
        lines.use(line << 20);
        lines.newest() = {line << 20, line, 0, 0};
    }
    REQUIRE(lines.full());
    const RecentLines::Found found = lines.use(0);
    CHECK(found.depth == 15);
    CHECK(found.sharers == ~Sharers{0});
}

} // namespace ffgpu::work
