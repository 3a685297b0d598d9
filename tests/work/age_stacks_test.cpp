// The vectors of the stacks of times against the same entry by entry.

#include "model/work/age_stacks.h"

#include <array>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

constexpr std::size_t Levels = 4;
constexpr std::size_t Rows = 2 + 4 + 8 + 16;

struct alignas(64) EntryGroup {
    std::array<AgeRows::Entry, AgeRows::Group> entries{};

    bool operator==(const EntryGroup&) const = default;
};

struct Stacks {
    explicit Stacks(std::uint32_t depth)
        : groups(Rows * ((depth + AgeRows::Group - 1) / AgeRows::Group)) {
        rows = {groups.front().entries.data(),
                Levels,
                depth,
                static_cast<std::uint32_t>(groups.size() / Rows * AgeRows::Group)};
    }
    Stacks(const Stacks&) = delete;

    std::vector<EntryGroup> groups;
    AgeRows rows;
};

} // namespace

TEST_CASE("vectors of times say and do what entry by entry does", "[curves]") {
    for (const std::uint32_t depth : {1u, 7u, 8u, 15u, 16u, 17u, 31u, 32u, 40u, 80u}) {
        INFO("depth " << depth);
        std::mt19937 random(depth);
        Stacks stacks(depth), plain(depth);
        std::vector<AgeRows::Entry> last(400, 0); // by line
        std::array<std::size_t, Levels + 1> levels_found{};
        for (AgeRows::Entry now = 2; now < 30000; now += 2) {
            const std::uint64_t line = random() % 2 ? random() % last.size() : random() % 40;
            const AgeRows::Entry latest = last[line] + AgeRows::Hole;
            std::array<std::uint32_t, Levels> found{}, expected{};
            const std::size_t levels = positions_in(stacks.rows, line, latest, found);
            REQUIRE(levels == positions_in_plainly(plain.rows, line, latest, expected));
            REQUIRE(found == expected);
            ++levels_found[levels];
            move_to_front(stacks.rows, line, latest, now);
            move_to_front_plainly(plain.rows, line, latest, now);
            REQUIRE(stacks.groups == plain.groups);
            last[line] = now;
        }
        CHECK(levels_found[0] > 0);
        CHECK(levels_found[Levels] > 0);
    }
}

} // namespace ffgpu::work
