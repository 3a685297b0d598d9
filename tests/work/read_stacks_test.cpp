// Where lines are found in the stacks of all sets, against a list of lines and holes for each set.

#include "model/work/read_stacks.h"
#include "model/work/set_reads.h"

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

// Of one number of sets, each a list of its lines, the newest first. A line that is thrown out
// leaves a hole; a use takes the uppermost of the holes and of the line's own place away.
class PlainStacks {
public:
    explicit PlainStacks(std::uint64_t sets)
        : sets_(sets) {}

    // Of one that is not there: how long the list is.
    std::size_t position(std::uint64_t line) const {
        const List& list = sets_[line % sets_.size()];
        return static_cast<std::size_t>(std::find(list.begin(), list.end(), line) - list.begin());
    }
    bool has(std::uint64_t line) const {
        return position(line) < sets_[line % sets_.size()].size();
    }
    void use(std::uint64_t line) {
        drop(line);
        List& list = sets_[line % sets_.size()];
        const auto hole = std::find(list.begin(), list.end(), Hole);
        if (hole != list.end()) list.erase(hole);
        list.insert(list.begin(), line);
    }
    void drop(std::uint64_t line) {
        List& list = sets_[line % sets_.size()];
        std::replace(list.begin(), list.end(), line, Hole);
    }
    void flush() { std::fill(sets_.begin(), sets_.end(), List{}); }
    std::vector<std::uint64_t> lines() const {
        std::vector<std::uint64_t> lines = sets_[0];
        std::erase(lines, Hole);
        return lines;
    }

private:
    static constexpr std::uint64_t Hole = ~std::uint64_t{0};
    using List = std::vector<std::uint64_t>;

    std::vector<List> sets_;
};

std::uint64_t next_line(std::mt19937& random, std::uint64_t before) {
    const unsigned kind = static_cast<unsigned>(random() % 8);
    if (kind < 4) return (before + random() % 3) % 120; // near
    if (kind < 7) return random() % 40;
    return random() % 120;
}

// Of 1, 2, 4 ... sets.
using Plain = std::vector<PlainStacks>;

struct Found {
    std::uint64_t last = ReadStacks::Never;
    bool known = false;
    std::uint32_t depth = 0;
    std::vector<std::uint32_t> positions{}; // of 2, 4 ... sets, as long as they are above 0
};

// All stacks: records are followed at once.
class AllStacks {
public:
    AllStacks(std::uint32_t most_sets,
              std::uint32_t most_ways,
              AgeStacks::Time most_times = AgeStacks::MostTimes)
        : most_ways_(most_ways)
        , sets_(most_sets, most_ways, most_times)
        , lines_(sets_.levels()) {}

    Found look_up(std::uint64_t line, std::uint64_t number) {
        if (const ReadStacks::Near near = lines_.look_up_near(line, number)) {
            Found found{near.last, true, near.depth};
            for (Sharers rest = near.positions; rest != 0; rest >>= 4)
                found.positions.push_back(
                    std::min(static_cast<std::uint32_t>(rest & 15), most_ways_));
            return found;
        }
        SetRead read;
        const ReadStacks::Found older = lines_.look_up_older(line, number, read);
        const std::span<const std::uint32_t> positions = sets_.use(read);
        return {older.last, older.known, older.depth, {positions.begin(), positions.end()}};
    }
    bool has(std::uint64_t line) { return lines_.has(line); }
    void drop(std::uint64_t line) {
        lines_.drop(line, reads_);
        follow();
    }
    void flush() {
        lines_.flush(reads_);
        follow();
    }
    std::vector<std::uint64_t> oldest_first() {
        std::vector<std::uint64_t> lines = lines_.oldest_first(reads_);
        follow();
        return lines;
    }

private:
    void follow() {
        for (const SetRead& read : reads_)
            sets_.use(read);
        reads_.clear();
    }

    std::uint32_t most_ways_;
    SetReads sets_;
    ReadStacks lines_;
    std::vector<SetRead> reads_;
};

void check_found(const Found& found,
                 const Plain& plain,
                 std::uint64_t line,
                 std::uint32_t most_ways) {
    REQUIRE(found.known == plain[0].has(line));
    if (!found.known) return;
    REQUIRE(found.depth == plain[0].position(line));
    for (std::size_t level = 0; level < 5; ++level) {
        const std::size_t position = plain[level + 1].position(line);
        const std::size_t told = level < found.positions.size() ? found.positions[level] : 0;
        REQUIRE(told == std::min<std::size_t>(position, most_ways));
    }
}

// Lines are thrown out by turns often and not at all.
bool throws_out(std::mt19937& random, std::uint64_t number) {
    return number / 2500 % 2 == 1 && random() % 40 == 0;
}

// Times that end soon are counted anew many times. Stacks are searched in groups: of a depth less
// than one, of whole ones, and with a rest.
TEST_CASE("lines stand in all stacks where plain lists of lines say", "[curves]") {
    using Shape = std::pair<std::uint32_t, AgeStacks::Time>; // most ways, most times
    for (const auto& [most_ways, most_times] : {Shape{9, 1u << 30},
                                                Shape{9, 1500},
                                                Shape{1, 1000},
                                                Shape{16, 2000},
                                                Shape{32, 3000},
                                                Shape{37, 3000}}) {
        INFO(most_ways << " ways");
        std::mt19937 random(most_times);
        AllStacks stacks(32, most_ways, most_times);
        Plain plain;
        for (std::uint64_t sets = 1; sets <= 32; sets *= 2)
            plain.emplace_back(sets);
        std::uint64_t line = 0;
        for (std::uint64_t number = 0; number < 20000; ++number) {
            line = next_line(random, line);
            check_found(stacks.look_up(line, number), plain, line, most_ways);
            for (PlainStacks& sets : plain)
                sets.use(line);
            if (throws_out(random, number)) {
                const std::uint64_t thrown_out = random() % 120;
                stacks.drop(thrown_out);
                for (PlainStacks& sets : plain)
                    sets.drop(thrown_out);
            }
            if (random() % 3000 != 0) continue;
            stacks.flush();
            for (PlainStacks& sets : plain)
                sets.flush();
        }
        const std::vector<std::uint64_t> newest_first = plain[0].lines();
        CHECK(stacks.oldest_first() ==
              std::vector<std::uint64_t>(newest_first.rbegin(), newest_first.rend()));
    }
}

TEST_CASE("a line's last look-up is told, also from before a flush", "[curves]") {
    AllStacks stacks(2, 2);
    CHECK(stacks.look_up(7, 3).last == ReadStacks::Never);
    CHECK(stacks.look_up(7, 5).last == 3);
    stacks.flush();
    const Found found = stacks.look_up(7, 9);
    CHECK(found.last == 5);
    CHECK_FALSE(found.known);
    CHECK(stacks.has(7));
    CHECK_FALSE(stacks.has(8));
}

} // namespace
} // namespace ffgpu::work
