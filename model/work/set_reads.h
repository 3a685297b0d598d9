// SetReads: where lines were in the stacks of 2, 4, 8 ... sets, while lines are only read: what
// ReadStacks leaves open of a line that was not among the newest (read_stacks.h). It is told in
// records, which another thread may read later.

#pragma once

#include "model/work/age_stacks.h"
#include "model/work/lookups.h"
#include "model/work/recent_lines.h"

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

// How many of the newest lines count beside a line's place below, a byte for each number of sets.
struct NewerSharers {
    static constexpr std::size_t Bytes = 8;
    static_assert(RecentLines::MostLevels <= 2 * Bytes);
    static_assert(std::endian::native == std::endian::little);

    std::array<std::uint64_t, 2> words{}; // of 2 sets the lowest byte of the first

    using Counts = std::array<std::uint8_t, 2 * Bytes>;
    Counts counts() const { return std::bit_cast<Counts>(words); }
};

// What happens in all sets: a line is looked up, then another leaves the top; either may be
// missing.
struct SetRead {
    using Time = RecentLines::Time;
    enum class Kind : std::uint8_t { Use, Drop, Flush };

    std::uint64_t line = 0;  // is looked up
    Time left = 0;           // when it left the top; 0: its positions are not asked for
    NewerSharers newer{};    // that left it before
    std::uint32_t depth = 0; // its position among all lines
    std::uint32_t quads = 0; // that look it up
    Reuse reuse = Reuse::Quad;

    Kind kind = Kind::Use;
    std::uint64_t leaving = 0; // the line that leaves the top, or is thrown out
    Time before = 0;           // when it had left it before; 0: never
    Time now = 0;              // 0: none leaves
};

class SetReads {
public:
    // Stacks of 2, 4 ... most_sets sets (a power of two), down to `most_ways`. Times are told apart
    // up to `most_times`, and counted anew then: more than twice as many as there are entries.
    SetReads(std::uint32_t most_sets,
             std::uint32_t most_ways,
             AgeStacks::Time most_times = AgeStacks::MostTimes);

    // Of 2, 4, 8 ... sets, as long as they are above 0; at most most_ways. Of records in order.
    std::span<const std::uint32_t> use(const SetRead& read);

    // It comes soon.
    void prefetch(const SetRead& read) const { stacks_.prefetch(read.line); }

    std::size_t levels() const { return stacks_.levels(); }

private:
    std::span<const std::uint32_t> positions(const SetRead& read);
    AgeStacks::Time short_of(SetRead::Time time) const;
    SetRead::Time long_of(AgeStacks::Time time) const;
    void count_anew();

    std::uint32_t most_ways_;
    AgeStacks::Time most_times_;
    AgeStacks stacks_;
    // Times are short in the stacks: those up to counted_ that stand there 2, 4, 6 ..., and what
    // lies between them odd; the later ones follow.
    std::vector<SetRead::Time> old_times_;
    SetRead::Time counted_ = 0, last_ = 0;
    std::array<std::uint32_t, RecentLines::MostLevels> positions_{};
};

} // namespace ffgpu::work
