// WriteBacks: how often LRU caches of one set count and any number of ways write a line back, from
// one pass. A line is dirty in the caches of more ways than the deepest position from which it was
// used again since it was written: its dirty level. It was written back by those of them that it
// fell out of (J. G. Thompson, A. J. Smith, Efficient (Stack) Algorithms for Analysis of Write-Back
// and Sector Memories, ACM TOCS 7 (1), 1989).

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

class WriteBacks {
public:
    static constexpr std::uint32_t Clean = ~std::uint32_t{0}; // a level; in no cache is it dirty

    // A line of this level was found at `position`; returns its level after the use.
    std::uint32_t used(std::uint32_t level, std::uint32_t position, bool write) {
        if (level != Clean && level < position) count(level, position);
        if (write) return 0;
        return level == Clean ? Clean : std::max(level, position);
    }
    // It leaves all caches by a flush, or those that are followed: each that has it dirty, or had,
    // has written it back then.
    void left(std::uint32_t level) {
        if (level != Clean) ++begin(level);
    }
    // It is overwritten where it was found: those that still have it need not write it back.
    void overwritten(std::uint32_t level, std::uint32_t position) {
        if (level != Clean && level < position) count(level, position);
    }

    // In a cache of `ways`.
    std::uint64_t in(std::uint32_t ways) const {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < std::min<std::size_t>(ways, changes_.size()); ++i)
            sum += changes_[i];
        return static_cast<std::uint64_t>(sum);
    }

private:
    // In the caches of more than `level` and up to `position` ways.
    void count(std::uint32_t level, std::uint32_t position) {
        ++begin(level);
        --begin(position);
    }
    std::int64_t& begin(std::uint32_t at) {
        if (at >= changes_.size()) changes_.resize(std::size_t{at} + 1, 0);
        return changes_[at];
    }

    std::vector<std::int64_t> changes_; // of the count, from this many ways to one more
};

} // namespace ffgpu::work
