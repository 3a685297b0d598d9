#include "model/work/age_stacks.h"

#include <algorithm>
#include <bit>

namespace ffgpu::work {
namespace {

std::uint32_t position_in(const AgeRows& rows, const AgeRows::Entry* stack, AgeRows::Entry latest) {
    std::uint32_t at = 0;
    while (at < rows.depth && stack[at] > latest)
        ++at;
    return at;
}

// The first entries a place down, for one in front of them; the last one of the stack is dropped.
void insert(const AgeRows& rows, AgeRows::Entry* stack, std::uint32_t at, AgeRows::Entry newest) {
    const std::uint32_t moved = std::min(at, rows.depth - 1);
    std::copy_backward(stack, stack + moved, stack + moved + 1);
    stack[0] = newest;
}

} // namespace

std::size_t positions_in_plainly(const AgeRows& rows,
                                 std::uint64_t line,
                                 AgeRows::Entry latest,
                                 std::span<std::uint32_t> positions) {
    for (std::size_t level = 0; level < rows.levels; ++level) {
        positions[level] = position_in(rows, rows.of(level, line), latest);
        if (positions[level] == 0) return level;
    }
    return rows.levels;
}

void move_to_front_plainly(const AgeRows& rows,
                           std::uint64_t line,
                           AgeRows::Entry latest,
                           AgeRows::Entry newest) {
    for (std::size_t level = 0; level < rows.levels; ++level) {
        AgeRows::Entry* const stack = rows.of(level, line);
        const std::uint32_t at = position_in(rows, stack, latest);
        if (at == 0 && latest > AgeRows::Hole) return;
        insert(rows, stack, at, newest);
    }
}

AgeStacks::AgeStacks(std::uint32_t most_sets, std::uint32_t depth) {
    rows_.levels = static_cast<std::size_t>(std::countr_zero(most_sets));
    rows_.depth = depth;
    rows_.stride = (depth + AgeRows::Group - 1) / AgeRows::Group * AgeRows::Group;
    groups_.resize((std::size_t{2} * most_sets - 2) * (rows_.stride / AgeRows::Group));
    if (!groups_.empty()) rows_.entries = groups_.front().entries.data();
}

std::uint32_t
AgeStacks::holes_above(std::size_t level, std::uint64_t line, std::uint32_t position) const {
    const Entry* const stack = rows_.of(level, line);
    std::uint32_t holes = 0;
    for (std::uint32_t at = 0; at < position; ++at)
        holes += static_cast<std::uint32_t>(stack[at] & Hole);
    return holes;
}

void AgeStacks::use_beside_holes(std::uint64_t line, Time before, Time now) {
    for (std::size_t level = 0; level < rows_.levels; ++level) {
        Entry* const stack = rows_.of(level, line);
        const std::uint32_t at = position_in(rows_, stack, entry_of(before) + Hole);
        if (at == 0 && before > 0) return; // and so it is with more sets
        insert(rows_, stack, close_hole(stack, at, before), entry_of(now));
    }
}

// The uppermost hole above the line's place is filled, and the place becomes one: returns where the
// hole was. The line's place, if there is none.
std::uint32_t AgeStacks::close_hole(Entry* stack, std::uint32_t at, Time before) {
    std::uint32_t hole = 0;
    while (hole < at && (stack[hole] & Hole) == 0)
        ++hole;
    if (hole == at) return at;
    if (before > 0 && at < rows_.depth)
        stack[at] |= Hole;
    else
        --holes_;
    return hole;
}

void AgeStacks::drop(std::uint64_t line, Time before) {
    for (std::size_t level = 0; level < rows_.levels; ++level) {
        Entry* const stack = rows_.of(level, line);
        const std::uint32_t at = position_in(rows_, stack, entry_of(before) + Hole);
        if (at == rows_.depth) continue;
        stack[at] |= Hole;
        ++holes_;
    }
}

void AgeStacks::flush() {
    std::fill(groups_.begin(), groups_.end(), EntryGroup{});
    holes_ = 0;
}

} // namespace ffgpu::work
