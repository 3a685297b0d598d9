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

    // Of 1, 2, 4 ... most_sets sets, those of several down to `most_ways`. Times are told apart up
    // to `most_times`, and counted anew then: more than there are lines and holes.
    ReadStacks(std::uint32_t most_sets,
               std::uint32_t most_ways,
               AgeStacks::Time most_times = AgeStacks::MostTimes);

    // What a look-up of a line among the newest found; its positions may be above most_ways.
    struct Near {
        std::uint32_t depth = RecentLines::Most; // its position among all lines
        Sharers positions = 0;                   // of 2, 4, 8 ... sets
        std::uint64_t last = Never;              // number of the line's look-up before

        explicit operator bool() const { return depth < RecentLines::Most; }
    };
    // Where the line is not among them, look_up_older() follows.
    Near look_up_near(std::uint64_t line, std::uint64_t number) {
        leaves_now_ = recent_.full();
        const RecentLines::Found found = recent_.use(line);
        if (found.depth == RecentLines::Most) return {};
        return {found.depth, found.sharers, std::exchange(recent_.newest().place, number)};
    }

    struct Found {
        std::uint64_t last = Never; // number of the line's look-up before
        bool known = false;         // looked up, and not thrown out since
        std::uint32_t depth = 0;    // its position among all lines
        // Of 2, 4, 8 ... sets, as long as they are above 0; at most most_ways.
        std::span<const std::uint32_t> positions{};
    };
    Found look_up_older(std::uint64_t line, std::uint64_t number);
    // Both.
    Found look_up(std::uint64_t line, std::uint64_t number);

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
    void count_newer_sharers(const Line& line);
    void leave(const RecentLines::Use& use);
    void all_leave();
    std::vector<std::uint32_t> older_first() const;
    void count_anew();

    std::uint32_t most_ways_;
    AgeStacks::Time most_times_;
    AgeStacks stacks_;
    RecentLines recent_;
    bool leaves_now_ = false; // the line in whose slot the newest is
    LineNumbers numbers_;
    std::vector<Line> lines_;
    LineStack all_;              // without those on top
    AgeStacks::Time leaves_ = 0; // of recent_
    std::array<std::uint32_t, RecentLines::MostLevels> positions_{}, sharers_{};
};

} // namespace ffgpu::work
