// ReadStacks: the LRU stacks of 1, 2, 4 ... sets at once, while lines are only read: where a line
// was when it is looked up, among all lines and, if it was one of the newest, in each set.
//
// The newest lines lie apart, on top of all stacks (recent_lines.h): most look-ups touch nothing
// else. The stacks below know a line from when it left the top; lines leave it in the order in
// which they were looked up. A line that is on top again still has its old place below. What there
// is to do below, in the stacks of several sets, is told in records (set_reads.h).
//
// Lines that are thrown out leave holes (set_stacks.h). Each use takes the uppermost of the holes
// and of its line's own place away, whichever order the uses come in; and above a line that stands
// on top no hole is: it would have been taken first.

#pragma once

#include "model/work/line_numbers.h"
#include "model/work/line_stack.h"
#include "model/work/recent_lines.h"
#include "model/work/set_reads.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace ffgpu::work {

class ReadStacks {
public:
    static constexpr std::uint64_t Never = ~std::uint64_t{0};

    // `levels`: numbers of sets above 1.
    explicit ReadStacks(std::size_t levels);

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
    };
    // `read`: what follows of it for all sets.
    Found look_up_older(std::uint64_t line, std::uint64_t number, SetRead& read);

    // It was looked up, and not thrown out since.
    bool has(std::uint64_t line);
    // What follows of these for all sets goes behind `reads`.
    void drop(std::uint64_t line, std::vector<SetRead>& reads);
    void flush(std::vector<SetRead>& reads);

    // Calls each(line, last) for all lines that were ever looked up.
    template <class Each>
    void for_each_line(Each&& each) const {
        for (const Line& line : lines_)
            if (line.last != Never) each(line.line, line.last);
    }
    // The lines since the last flush, the newest last. None of them is on top any more.
    std::vector<std::uint64_t> oldest_first(std::vector<SetRead>& reads);

private:
    struct Line {
        std::uint64_t line = 0;
        std::uint64_t last = Never; // of one on top: not told
        RecentLines::Time left = 0; // RecentLines::Use
    };

    Line& record(std::uint32_t id);
    NewerSharers newer_sharers(const Line& line) const;
    void leave(const RecentLines::Use& use, SetRead& read);
    void all_leave(std::vector<SetRead>& reads);
    std::vector<std::uint32_t> older_first() const;

    RecentLines recent_;
    // By the number of lowest bits that two lines share: one for each number of sets.
    std::array<NewerSharers, 65> shared_{};
    bool leaves_now_ = false; // the line in whose slot the newest is
    LineNumbers numbers_;
    std::vector<Line> lines_;
    LineStack all_;                // without those on top
    RecentLines::Time leaves_ = 0; // of recent_
};

} // namespace ffgpu::work
