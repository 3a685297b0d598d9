// Where lines are found in the stacks of all sets, against one list of lines by their last use.

#include "model/work/read_stacks.h"

#include <algorithm>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// The newest first; of sets the lines that share the lowest bits of their numbers.
class PlainStack {
public:
    // How many lines of its set were used since it was; of one that is not there: all of them.
    std::size_t position(std::uint64_t line, std::uint64_t sets) const {
        std::size_t newer = 0;
        for (const std::uint64_t other : lines_) {
            if (other == line) break;
            newer += other % sets == line % sets;
        }
        return newer;
    }
    bool has(std::uint64_t line) const {
        return std::find(lines_.begin(), lines_.end(), line) != lines_.end();
    }
    void use(std::uint64_t line) {
        std::erase(lines_, line);
        lines_.insert(lines_.begin(), line);
    }
    void flush() { lines_.clear(); }
    const std::vector<std::uint64_t>& lines() const { return lines_; }

private:
    std::vector<std::uint64_t> lines_;
};

std::uint64_t next_line(std::mt19937& random, std::uint64_t before) {
    const unsigned kind = static_cast<unsigned>(random() % 8);
    if (kind < 4) return (before + random() % 3) % 120; // near
    if (kind < 7) return random() % 40;
    return random() % 120;
}

void check_found(const ReadStacks::Found& found, const PlainStack& plain, std::uint64_t line) {
    constexpr std::uint32_t MostWays = 9;
    REQUIRE(found.known == plain.has(line));
    if (!found.known) return;
    REQUIRE(found.depth == plain.position(line, 1));
    for (std::size_t level = 0; level < 5; ++level) {
        const std::size_t position = plain.position(line, std::uint64_t{2} << level);
        const std::size_t told = level < found.positions.size() ? found.positions[level] : 0;
        REQUIRE(told == std::min<std::size_t>(position, MostWays));
    }
}

// Times that end soon are counted anew many times.
TEST_CASE("lines stand in all stacks where a plain list of lines says", "[curves]") {
    for (const AgeStacks::Time most_times : {1u << 31, 150u}) {
        std::mt19937 random(most_times);
        ReadStacks stacks(32, 9, most_times);
        PlainStack plain;
        std::uint64_t line = 0;
        for (std::uint64_t number = 0; number < 20000; ++number) {
            line = next_line(random, line);
            check_found(stacks.look_up(line, number), plain, line);
            plain.use(line);
            if (random() % 3000 != 0) continue;
            stacks.flush();
            plain.flush();
        }
        const std::vector<std::uint64_t>& newest_first = plain.lines();
        CHECK(stacks.oldest_first() ==
              std::vector<std::uint64_t>(newest_first.rbegin(), newest_first.rend()));
    }
}

TEST_CASE("a line's last look-up is told, also from before a flush", "[curves]") {
    ReadStacks stacks(2, 2);
    CHECK(stacks.look_up(7, 3).last == ReadStacks::Never);
    CHECK(stacks.look_up(7, 5).last == 3);
    stacks.flush();
    const ReadStacks::Found found = stacks.look_up(7, 9);
    CHECK(found.last == 5);
    CHECK_FALSE(found.known);
    CHECK(stacks.has(7));
    CHECK_FALSE(stacks.has(8));
}

} // namespace
} // namespace ffgpu::work
