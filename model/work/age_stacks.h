// AgeStacks: the LRU stacks of a cache's sets, each down to a depth, while lines are only read and
// nothing is thrown out but by flushes: a stack holds the times of its lines' last uses, the latest
// first, and a line's position is the number of times after its own. What SetStacks tells of them,
// without looking for the line.
//
// A line that is its set's last used need not be used again here: a time of its that is too early
// is still the set's latest.

#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace ffgpu::work {

class AgeStacks {
public:
    using Time = std::uint32_t; // above 0

    // `sets` a power of two.
    AgeStacks(std::uint32_t sets, std::uint32_t depth)
        : mask_(sets - 1)
        , depth_(depth)
        , times_(std::size_t{sets} * depth, 0) {}

    // The position of a line that was used last at `time`; the depth, if it is not known any more.
    // With time 0: how many lines there are.
    std::uint32_t position(std::uint64_t line, Time time) const {
        const Time* const stack = times_.data() + set_of(line);
        if (stack[0] <= time) return 0;
        if (stack[depth_ - 1] > time) return depth_;
        const Time* first = stack; // of `rest` places, of which the last but one may be later
        for (std::uint32_t rest = depth_; rest > 1;) {
            const std::uint32_t half = rest / 2;
            first += first[half - 1] > time ? half : 0;
            rest -= half;
        }
        return static_cast<std::uint32_t>(first - stack) + (*first > time);
    }

    // Uses a line again that was used last at `before`, or never (0). Returns its position.
    std::uint32_t use(std::uint64_t line, Time before, Time now) {
        const std::uint32_t at = position(line, before);
        if (at == 0 && before > 0) return 0;
        Time* const stack = times_.data() + set_of(line);
        std::memmove(stack + 1, stack, std::min(at, depth_ - 1) * sizeof *stack);
        stack[0] = now;
        return at;
    }

    void flush() { std::fill(times_.begin(), times_.end(), Time{0}); }

private:
    std::size_t set_of(std::uint64_t line) const {
        return static_cast<std::size_t>(line & mask_) * depth_;
    }

    std::uint64_t mask_;
    std::uint32_t depth_;
    std::vector<Time> times_;
};

} // namespace ffgpu::work
