// AgeStacks: the LRU stacks of caches of 2, 4, 8 ... sets, each down to a depth, while lines are
// only read: a stack holds the times of its lines' last uses, the latest first, and a line's
// position is the number of times after its own. What SetStacks tells of them, without looking for
// the line.
//
// A line that is its set's last used need not be used again here: a time of its that is too early
// is still the set's latest. Holes are as in set_stacks.h: the times of lines that were thrown out.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

// The stacks of 2 sets, then of 4 ..., each of `stride` entries: twice a time, and 1 where it is a
// hole's; 0: none. What is asked for is told down to `depth`.
struct AgeRows {
    using Entry = std::int32_t;
    static constexpr Entry Hole = 1;
    static constexpr std::uint32_t Group = 16; // a line of most processors' caches

    Entry* entries = nullptr;
    std::size_t levels = 0; // numbers of sets
    std::uint32_t depth = 0;
    std::uint32_t stride = 0; // a multiple of Group

    Entry* of(std::size_t level, std::uint64_t line) const {
        const std::size_t sets = std::size_t{2} << level;
        return entries + (sets - 2 + static_cast<std::size_t>(line & (sets - 1))) * stride;
    }
};

// How many entries are above `latest` in the stacks of `line`: of 2, 4, 8 ... sets, as long as
// there are some. Returns of how many numbers of sets that is.
std::size_t positions_in(const AgeRows& rows,
                         std::uint64_t line,
                         AgeRows::Entry latest,
                         std::span<std::uint32_t> positions);
// Where there are no holes: a line whose entry is the first that is not above `latest` moves to the
// front, as `newest`, unless it is there, as then it is of more sets, too. `latest` is Hole for a
// line that has no entry.
void move_to_front(const AgeRows& rows,
                   std::uint64_t line,
                   AgeRows::Entry latest,
                   AgeRows::Entry newest);

// Entry by entry: what they say.
std::size_t positions_in_plainly(const AgeRows& rows,
                                 std::uint64_t line,
                                 AgeRows::Entry latest,
                                 std::span<std::uint32_t> positions);
void move_to_front_plainly(const AgeRows& rows,
                           std::uint64_t line,
                           AgeRows::Entry latest,
                           AgeRows::Entry newest);

class AgeStacks {
public:
    using Time = std::uint32_t; // above 0
    static constexpr Time MostTimes = ~Time{0} / 4;

    // `most_sets` a power of two.
    AgeStacks(std::uint32_t most_sets, std::uint32_t depth);
    AgeStacks(const AgeStacks&) = delete;
    AgeStacks& operator=(const AgeStacks&) = delete;

    std::size_t levels() const { return rows_.levels; } // of 2, 4, 8 ... sets

    // The positions of a line that was used last at `time`, as positions_in(); the depth, where it
    // is not known any more.
    std::size_t positions(std::uint64_t line, Time time, std::span<std::uint32_t> positions) const {
        return positions_in(rows_, line, entry_of(time) + Hole, positions);
    }

    // It will be asked for the line's positions soon, and is larger than the processor's caches.
    void prefetch(std::uint64_t line) const {
        for (std::size_t level = 0; level < rows_.levels; ++level)
            __builtin_prefetch(rows_.of(level, line));
    }

    bool has_holes() const { return holes_ > 0; }
    // Of the set of `line`, above the position.
    std::uint32_t holes_above(std::size_t level, std::uint64_t line, std::uint32_t position) const;

    // Uses a line again that was used last at `before`, or never (0), in all sets.
    void use(std::uint64_t line, Time before, Time now) {
        if (holes_ > 0) return use_beside_holes(line, before, now);
        move_to_front(rows_, line, entry_of(before) + Hole, entry_of(now));
    }

    // Throws a line out that was used last at `before`.
    void drop(std::uint64_t line, Time before);
    void flush();

    // Calls each(time) for all times.
    template <class Each>
    void for_each_time(Each&& each) const {
        for (const EntryGroup& group : groups_)
            for (const Entry entry : group.entries)
                if (entry != 0) each(static_cast<Time>(entry / 2));
    }
    // All times become now_of(time), in the same order.
    template <class NowOf>
    void count_anew(NowOf&& now_of) {
        for (Entry& entry : entries())
            if (entry != 0) entry = entry_of(now_of(static_cast<Time>(entry / 2))) | (entry & Hole);
    }

private:
    using Entry = AgeRows::Entry;
    static constexpr Entry Hole = AgeRows::Hole;

    static Entry entry_of(Time time) { return static_cast<Entry>(2 * time); }
    void use_beside_holes(std::uint64_t line, Time before, Time now);
    std::uint32_t close_hole(Entry* stack, std::uint32_t at, Time before);

    // A group: of a size and place that vectors are loaded from.
    struct alignas(AgeRows::Group * sizeof(Entry)) EntryGroup {
        std::array<Entry, AgeRows::Group> entries{};
    };

    std::span<Entry> entries() { return {rows_.entries, groups_.size() * AgeRows::Group}; }

    std::vector<EntryGroup> groups_;
    AgeRows rows_;            // of groups_
    std::uint64_t holes_ = 0; // in all of them
};

} // namespace ffgpu::work
