// Passage: a queue inside a unit, from one of its steps to the next, in order: what it tells of
// the items that have passed. Counts are modulo 2^32.

#pragma once

#include <algorithm>
#include <cstdint>

namespace ffgpu::timing {

struct Passage {
    std::uint32_t entered = 0, left = 0; // items
    std::uint32_t looked_up = 0;         // lines, by the step before it
    std::uint32_t worked = 0;            // cycles, by the step behind it
    // Units that began with an item that came, and the cycles that they take for it.
    std::uint32_t begun = 0, begun_cycles = 0;
    std::uint64_t awaited = 0; // the last of the fills that those that left waited for
    // Items, up to the last one that an item waited for to be gone before it could come, as both
    // are of one place; items that did so.
    std::uint32_t behind = 0, waited = 0;

    // An item comes, which takes a unit so many cycles, this one included.
    void enter_unit(std::uint64_t cycles) {
        ++entered;
        ++begun;
        begun_cycles += static_cast<std::uint32_t>(cycles);
    }
    // It goes up with whatever is told: units begin with what enters, and what leaves is what
    // others waited for.
    std::uint32_t moves() const { return entered + left + looked_up + worked + waited; }
    bool operator==(const Passage&) const = default;
    void leave(std::uint64_t ticket = 0) {
        ++left;
        awaited = std::max(awaited, ticket);
    }
};

} // namespace ffgpu::timing
