// RecentLines: the top of the LRU stacks of one line size: the lines looked up last. Of all sets
// and ways at once these few tell where a line was that is found among them: in 2^l sets its
// position is the number of newer lines whose numbers share the lowest l bits. Most look-ups end
// here and touch no other stack.
//
// A line keeps its slot as long as it is here; which lines are newer than it is a bit each.

#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

namespace ffgpu::work {

using LineSlots = std::uint16_t; // a bit each

// What is compared of all lines at once, slot by slot.
struct RecentLineSlots {
    static constexpr unsigned Count = 16;

    alignas(64) std::array<std::uint32_t, Count> low{}, high{}; // of the lines' numbers
    alignas(64) std::array<std::uint32_t, Count> left{};        // RecentLines::Use
    alignas(32) std::array<LineSlots, Count> newer{};           // lines that were looked up later
    LineSlots used = 0;
};

// Which of `slots` share a set with `line`, of 2, 4, 8 ... sets: how many, as long as there are
// any. Returns for how many numbers of sets that is, at most for as many as `counts` has.
std::size_t sharers(const RecentLineSlots& all,
                    LineSlots slots,
                    std::uint64_t line,
                    std::span<std::uint32_t> counts);

// Makes the line the newest, where it is here.
struct RecentUse {
    unsigned slot = RecentLineSlots::Count; // none, if it is not here
    std::uint32_t newer = 0;                // lines that were newer till now
    std::size_t levels = 0;                 // sharers() of these
};
RecentUse use_recent(RecentLineSlots& all, std::uint64_t line, std::span<std::uint32_t> counts);

// Those whose line left the top last as the `left`-th or before; `left` is less than 2^31.
LineSlots left_by(const RecentLineSlots& all, std::uint32_t left);

// The slot of the line than which all others are newer, where there is one.
unsigned oldest_slot(const RecentLineSlots& all);

// The four of them one by one: what they say.
std::size_t sharers_plainly(const RecentLineSlots& all,
                            LineSlots slots,
                            std::uint64_t line,
                            std::span<std::uint32_t> counts);
RecentUse
use_recent_plainly(RecentLineSlots& all, std::uint64_t line, std::span<std::uint32_t> counts);
LineSlots left_by_plainly(const RecentLineSlots& all, std::uint32_t left);
unsigned oldest_slot_plainly(const RecentLineSlots& all);

class RecentLines {
public:
    static constexpr unsigned Most = RecentLineSlots::Count;

    struct Use {
        std::uint64_t place = 0; // of its last look-up
        std::uint32_t left = 0;  // which one it was to leave the top when it did last; 0: none
        std::uint32_t id = 0;
    };

    unsigned size() const { return static_cast<unsigned>(std::popcount(slots_.used)); }
    bool full() const { return slots_.used == LineSlots(~0u); }
    bool is_newest(std::uint64_t line) const { return slots_.used != 0 && newest_line_ == line; }
    bool has(unsigned slot) const { return (slots_.used >> slot & 1) != 0; }
    // `Most`, if it is not here.
    unsigned slot_of(std::uint64_t line) const;

    // As use_recent().
    RecentUse use(std::uint64_t line, std::span<std::uint32_t> counts) {
        const RecentUse found = use_recent(slots_, line, counts);
        if (found.slot < Most) newest_ = found.slot, newest_line_ = line;
        return found;
    }
    // Not where it is full: drop() first.
    void add(std::uint64_t line, const Use& use);

    const RecentLineSlots& slots() const { return slots_; }
    std::uint64_t line(unsigned slot) const {
        return std::uint64_t{slots_.high[slot]} << 32 | slots_.low[slot];
    }
    Use use_of(unsigned slot) const { return {places_[slot], slots_.left[slot], ids_[slot]}; }
    std::uint64_t& place(unsigned slot) { return places_[slot]; }
    std::uint64_t& newest_place() { return places_[newest_]; }
    void set_left(unsigned slot, std::uint32_t left) { slots_.left[slot] = left; }

    // Where there is one.
    unsigned oldest() const { return oldest_slot(slots_); }
    void drop(unsigned oldest) { slots_.used &= static_cast<LineSlots>(~(1u << oldest)); }
    void clear() { slots_.used = 0; }

private:
    RecentLineSlots slots_;
    std::array<std::uint64_t, Most> places_{};
    std::array<std::uint32_t, Most> ids_{};
    unsigned newest_ = 0;
    std::uint64_t newest_line_ = 0;
};

} // namespace ffgpu::work
