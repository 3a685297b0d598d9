// The vectors of the newest lines against the same one by one.

#include "model/work/recent_lines.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <span>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

using Counts = std::array<std::uint32_t, 31>;

// Lines that share many low bits, few, and only the upper half of their numbers.
std::uint64_t any_line(std::mt19937& random) {
    const std::uint64_t number = random() % 24;
    switch (random() % 3) {
    case 0:
        return number;
    case 1:
        return number << 6;
    default:
        return number << 31 | (random() % 2);
    }
}

RecentLineSlots any_slots(std::mt19937& random) {
    RecentLineSlots all;
    all.used = static_cast<LineSlots>(random());
    for (unsigned slot = 0; slot < RecentLineSlots::Count; ++slot) {
        const std::uint64_t line = any_line(random);
        all.low[slot] = static_cast<std::uint32_t>(line);
        all.high[slot] = static_cast<std::uint32_t>(line >> 32);
        all.left[slot] = random() % 4;
        all.newer[slot] = static_cast<LineSlots>(random());
    }
    // A line is here once.
    for (unsigned slot = 1; slot < RecentLineSlots::Count; ++slot)
        for (unsigned other = 0; other < slot; ++other)
            if (all.low[slot] == all.low[other] && all.high[slot] == all.high[other])
                all.used &= static_cast<LineSlots>(~(1u << slot));
    return all;
}

bool equal(const RecentLineSlots& a, const RecentLineSlots& b) {
    return a.low == b.low && a.high == b.high && a.left == b.left && a.newer == b.newer &&
           a.used == b.used;
}

} // namespace

TEST_CASE("vectors of the newest lines say what one by one does", "[curves]") {
    std::mt19937 random(20);
    std::size_t found = 0;
    for (int i = 0; i < 20000; ++i) {
        const RecentLineSlots all = any_slots(random);
        const std::uint64_t line = any_line(random);
        const std::size_t levels = random() % (Counts().size() + 1);
        Counts expected{}, counts{};
        const auto slots = static_cast<LineSlots>(random());
        REQUIRE(sharers(all, slots, line, std::span(counts).first(levels)) ==
                sharers_plainly(all, slots, line, std::span(expected).first(levels)));
        REQUIRE(counts == expected);

        const std::uint32_t left = i % 50 == 0 ? (1u << 31) - 1 : random() % 4;
        REQUIRE(left_by(all, left) == left_by_plainly(all, left));

        RecentLineSlots after = all, expected_after = all;
        const RecentUse use = use_recent(after, line, std::span(counts).first(levels));
        const RecentUse expected_use =
            use_recent_plainly(expected_after, line, std::span(expected).first(levels));
        REQUIRE(use.slot == expected_use.slot);
        REQUIRE(use.newer == expected_use.newer);
        REQUIRE(use.levels == expected_use.levels);
        REQUIRE(counts == expected);
        REQUIRE(equal(after, expected_after));
        found += use.slot < RecentLineSlots::Count;

        std::uint16_t newer = 0; // a line after another, in any order of slots
        RecentLineSlots in_order = all;
        std::array<unsigned, RecentLineSlots::Count> order{};
        std::iota(order.begin(), order.end(), 0u);
        std::shuffle(order.begin(), order.end(), random);
        for (const unsigned slot : order) {
            in_order.newer[slot] = newer;
            newer |= static_cast<LineSlots>(1u << slot);
        }
        if (in_order.used != 0) REQUIRE(oldest_slot(in_order) == oldest_slot_plainly(in_order));
    }
    CHECK(found > 1000);
}

TEST_CASE("the oldest of the newest lines leaves first", "[curves]") {
    RecentLines lines;
    std::array<std::uint32_t, 4> counts{};
    for (std::uint64_t line = 0; line < RecentLines::Most; ++line)
        lines.add(line, {});
    REQUIRE(lines.full());
    // Of 2, 4, 8 and 16 sets: 15 newer lines, 7 of which are odd ...
    const RecentUse use = lines.use(0, counts);
    CHECK(use.levels == 3);
    CHECK(counts == std::array<std::uint32_t, 4>{7, 3, 1, 0});
    CHECK(lines.is_newest(0));
    for (std::uint64_t line = 1; line < RecentLines::Most; ++line) {
        CHECK(lines.line(lines.oldest()) == line);
        lines.drop(lines.oldest());
    }
    CHECK(lines.line(lines.oldest()) == 0);
    lines.add(40, {});
    CHECK(lines.line(lines.oldest()) == 0);
    lines.clear();
    CHECK_FALSE(lines.is_newest(40));
    CHECK(lines.slot_of(40) == RecentLines::Most);
}

} // namespace ffgpu::work
