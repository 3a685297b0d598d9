// SetStacks: the LRU stacks of a cache's sets, each down to a depth. A line's position in its set's
// stack is the number of lines of the set that were used since: all caches of these sets and more
// ways hit (R. L. Mattson et al., Evaluation Techniques for Storage Hierarchies, IBM Systems
// Journal 9 (2), 1970).
//
// A line that is thrown out from outside leaves a hole at its position: a free way of the caches
// that held it. The next line that comes from below, or from elsewhere, takes the uppermost hole;
// in caches that did hit, the hole is where the line came from.

#pragma once

#include "model/work/write_backs.h"

#include <cstdint>
#include <vector>

namespace ffgpu::work {

class SetStacks {
public:
    static constexpr std::uint32_t NotThere = ~std::uint32_t{0};

    // `sets` a power of two.
    SetStacks(std::uint32_t sets, std::uint32_t depth)
        : mask_(sets - 1)
        , depth_(depth)
        , stride_((depth + Block - 1) / Block * Block)
        , lines_(std::size_t{sets} * stride_, Empty) {}

    // A line, its set's part of its number, and whether it is written.
    struct Use {
        std::uint32_t id = 0;
        std::uint64_t line = 0;
        bool write = false;
    };

    // Uses a line that may be there (`may_be`); returns the position at which it was, or NotThere.
    std::uint32_t use(const Use& use, bool may_be);

    // Forgets a line; what is dirty of it is written back, or is not, if all of it is overwritten.
    void drop(const Use& line, bool whole);
    void flush();

    std::uint32_t depth() const { return depth_; }
    const WriteBacks& write_backs() const { return write_backs_; }

private:
    static constexpr std::uint32_t Empty = ~std::uint32_t{0}, Hole = Empty - 1;
    static constexpr std::uint32_t Block = 8; // lines that are compared at once

    std::uint32_t find(std::size_t set, std::uint32_t id) const;
    std::size_t set_of(std::uint64_t line) const {
        return static_cast<std::size_t>(line & mask_) * stride_;
    }
    std::uint32_t level(std::size_t at) const {
        return dirty_.empty() ? WriteBacks::Clean : dirty_[at];
    }
    void set_level(std::size_t at, std::uint32_t level) {
        if (!dirty_.empty()) dirty_[at] = level;
    }
    void push_down(std::size_t set, std::uint32_t to);
    std::uint32_t use_clean(const Use& use);

    std::uint64_t mask_;
    std::uint32_t depth_, stride_;
    std::vector<std::uint32_t> lines_; // of a set the newest first
    std::vector<std::uint32_t> dirty_; // their levels; empty: nothing was ever written
    std::uint32_t holes_ = 0;          // in all sets
    bool used_ = false;                // since the last flush
    WriteBacks write_backs_;
};

} // namespace ffgpu::work
