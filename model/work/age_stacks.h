// AgeStacks: the LRU stacks of a cache's sets, each down to a depth, while lines are only read: a
// stack holds the times of its lines' last uses, the latest first, and a line's position is the
// number of times after its own. What SetStacks tells of them, without looking for the line.
//
// A line that is its set's last used need not be used again here: a time of its that is too early
// is still the set's latest. Holes are as in set_stacks.h: the times of lines that were thrown out.

#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

namespace ffgpu::work {

class AgeStacks {
public:
    using Time = std::uint32_t; // above 0
    static constexpr Time MostTimes = ~Time{0} / 2;

    // `sets` a power of two.
    AgeStacks(std::uint32_t sets, std::uint32_t depth)
        : mask_(sets - 1)
        , depth_(depth)
        , entries_(std::size_t{sets} * depth, 0) {}

    // The position of a line that was used last at `time`; the depth, if it is not known any more.
    // With time 0: how many lines and holes there are.
    std::uint32_t position(std::uint64_t line, Time time) const {
        const Entry* const stack = entries_.data() + set_of(line);
        const Entry latest = 2 * time + 1;
        if (stack[0] <= latest) return 0;
        if (stack[depth_ - 1] > latest) return depth_;
        // A group at a time: most lines stand near the top.
        std::uint32_t at = 0;
        while (at + Group < depth_ && stack[at + Group - 1] > latest)
            at += Group;
        if (at + Group <= depth_) return at + later_in_group(stack + at, latest);
        while (stack[at] > latest)
            ++at;
        return at;
    }

    // It will be asked for the line's position soon, and is larger than the processor's caches.
    void prefetch(std::uint64_t line) const {
        const Entry* const stack = entries_.data() + set_of(line);
        __builtin_prefetch(stack);
        __builtin_prefetch(stack + depth_ - 1);
    }

    // Of the set of `line`, above the position.
    std::uint32_t holes_above(std::uint64_t line, std::uint32_t position) const {
        if (holes_ == 0) return 0;
        const Entry* const stack = entries_.data() + set_of(line);
        std::uint32_t holes = 0;
        for (std::uint32_t at = 0; at < position; ++at)
            holes += stack[at] & Hole;
        return holes;
    }

    // Uses a line again that was used last at `before`, or never (0). Returns its position.
    std::uint32_t use(std::uint64_t line, Time before, Time now) {
        const std::uint32_t at = position(line, before);
        if (at == 0 && before > 0) return 0;
        Entry* const stack = entries_.data() + set_of(line);
        const std::uint32_t hole = holes_ > 0 ? uppermost_hole(stack, at) : at;
        if (hole < at && before > 0 && at < depth_)
            stack[at] |= Hole;
        else if (hole < at)
            --holes_;
        std::memmove(stack + 1, stack, std::min(hole, depth_ - 1) * sizeof *stack);
        stack[0] = 2 * now;
        return at;
    }

    // Throws a line out that was used last at `before`.
    void drop(std::uint64_t line, Time before) {
        const std::uint32_t at = position(line, before);
        if (at == depth_) return;
        entries_[set_of(line) + at] |= Hole;
        ++holes_;
    }

    void flush() {
        std::fill(entries_.begin(), entries_.end(), Entry{0});
        holes_ = 0;
    }

    // Calls each(time) for all times.
    template <class Each>
    void for_each_time(Each&& each) const {
        for (const Entry entry : entries_)
            if (entry != 0) each(entry / 2);
    }
    // All times become now_of(time), in the same order.
    template <class NowOf>
    void count_anew(NowOf&& now_of) {
        for (Entry& entry : entries_)
            if (entry != 0) entry = 2 * now_of(entry / 2) | (entry & Hole);
    }

private:
    using Entry = std::uint32_t; // twice the time, and Hole; 0: none
    static constexpr Entry Hole = 1;
    static constexpr std::uint32_t Group = 16; // a line of most processors' caches

    std::size_t set_of(std::uint64_t line) const {
        return static_cast<std::size_t>(line & mask_) * depth_;
    }
    static std::uint32_t later_in_group(const Entry* group, Entry latest) {
        std::uint32_t later = 0;
        for (std::uint32_t i = 0; i < Group; ++i)
            later += group[i] > latest;
        return later;
    }
    // `end` if none is above it.
    static std::uint32_t uppermost_hole(const Entry* stack, std::uint32_t end) {
        std::uint32_t at = 0;
        while (at < end && (stack[at] & Hole) == 0)
            ++at;
        return at;
    }

    std::uint64_t mask_;
    std::uint32_t depth_;
    std::vector<Entry> entries_;
    std::uint64_t holes_ = 0; // in all sets
};

} // namespace ffgpu::work
