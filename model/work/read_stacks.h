// ReadStacks: the LRU stacks of 1, 2, 4 ... sets at once, while lines are only read: where a line
// was in each of them when it is looked up.
//
// The newest lines lie apart, on top of all stacks (recent_lines.h): most look-ups touch nothing
// else. The stacks below know a line from when it left the top; lines leave it in the order in
// which they were looked up. A line that is on top again still has its old place below.
//
// Lines that are thrown out leave holes (set_stacks.h). Each use takes the uppermost of the holes
// and of its line's own place away, whichever order the uses come in; and above a line that stands
// on top no hole is: it would have been taken first.

#pragma once

#include "model/work/age_stacks.h"
#include "model/work/line_numbers.h"
#include "model/work/line_stack.h"
#include "model/work/recent_lines.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace ffgpu::work {

class ReadStacks {
public:
    static constexpr std::uint64_t Never = ~std::uint64_t{0};
    static constexpr std::size_t MostLevels = 32;

    // Of 1, 2, 4 ... most_sets sets, those of several down to `most_ways`. Times are told apart up
    // to `most_times`, and counted anew then: more than there are lines and holes.
    ReadStacks(std::uint32_t most_sets,
               std::uint32_t most_ways,
               AgeStacks::Time most_times = AgeStacks::MostTimes);

    // What a look-up found.
    struct Found {
        std::uint64_t last = Never; // number of the line's look-up before
        bool known = false;         // looked up, and not thrown out since
        std::uint32_t depth = 0;    // its position among all lines
        // Of 2, 4, 8 ... sets, as long as they are above 0; at most most_ways.
        std::span<const std::uint32_t> positions{};
    };
    Found look_up(std::uint64_t line, std::uint64_t number);

    // The same of a line that was the last one looked up: where it is, it stays. Else nothing is
    // done.
    std::optional<std::uint64_t> look_up_last(std::uint64_t line, std::uint64_t number) {
        if (!recent_.is_newest(line)) return std::nullopt;
        return std::exchange(recent_.newest_place(), number);
    }

    // It was looked up, and not thrown out since.
    bool has(std::uint64_t line);
    void drop(std::uint64_t line);
    void flush();

    // Calls each(line, last) for all lines that were ever looked up.
    template <class Each>
    void for_each_line(Each&& each) const {
        for (const Line& line : lines_)
            if (line.last != Never) each(line.line, line.last);
    }
    // The lines since the last flush, the newest last. None of them is on top any more.
    std::vector<std::uint64_t> oldest_first();

private:
    struct Line {
        std::uint64_t line = 0;
        std::uint64_t last = Never; // of one on top: not told
        AgeStacks::Time left = 0;   // RecentLines::Use
    };

    Line& record(std::uint32_t id);
    void find_older(std::uint32_t id, Found& found);
    void prefetch(std::uint64_t line) const;
    void oldest_leaves();
    void all_leave();
    std::vector<std::uint32_t> older_first() const;
    void count_anew();

    std::uint32_t most_ways_;
    AgeStacks::Time most_times_;
    RecentLines recent_;
    LineNumbers numbers_;
    std::vector<Line> lines_;
    LineStack all_; // without those on top
    std::vector<AgeStacks> stacks_;
    AgeStacks::Time leaves_ = 0; // of recent_
    std::array<std::uint32_t, MostLevels> positions_{}, sharers_{};
};

} // namespace ffgpu::work
