// Replacement policies. Each keeps a stamp a line, which it sets when the line is filled or used,
// and chooses the line of a full set that gives way from the stamps alone.

#pragma once

#include "model/work/cache_policy.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace ffgpu::work {

inline constexpr std::uint64_t NeverUsedAgain = ~std::uint64_t{0};

// When a line is looked up: the look-up's number, and that of the line's next look-up, which only
// optimal replacement asks for.
struct LookupTime {
    std::uint64_t now = 0;
    std::uint64_t next_use = NeverUsedAgain;
};

class ReplacementPolicy {
public:
    explicit ReplacementPolicy(const CachePolicy& policy)
        : kind_(policy.replacement)
        , lots_(policy.replacement_seed * Multiplier + Increment) {}

    void filled(std::uint64_t& stamp, const LookupTime& time) const {
        stamp = kind_ == Replacement::Optimal ? time.next_use : time.now;
    }

    void used(std::uint64_t& stamp, const LookupTime& time) const {
        if (kind_ == Replacement::Lru) stamp = time.now;
        if (kind_ == Replacement::Optimal) stamp = time.next_use;
    }

    // The way of a full set that gives way.
    std::size_t victim(std::span<const std::uint64_t> stamps) {
        switch (kind_) {
        case Replacement::Lru:
        case Replacement::Fifo:
            break; // The smallest stamp: of the last use, or of the fill.
        case Replacement::Random:
            return draw(stamps.size());
        case Replacement::Optimal: // L. A. Belady, IBM Systems Journal 5 (2), 1966
            return position(stamps, std::max_element(stamps.begin(), stamps.end()));
        }
        return position(stamps, std::min_element(stamps.begin(), stamps.end()));
    }

private:
    // D. E. Knuth's 64-bit linear congruential generator (MMIX); its upper bits are the good ones.
    static constexpr std::uint64_t Multiplier = 6364136223846793005u;
    static constexpr std::uint64_t Increment = 1442695040888963407u;

    static std::size_t position(std::span<const std::uint64_t> stamps, auto found) {
        return static_cast<std::size_t>(found - stamps.begin());
    }
    std::size_t draw(std::size_t ways) {
        lots_ = lots_ * Multiplier + Increment;
        return static_cast<std::size_t>((lots_ >> 32) * ways >> 32);
    }

    Replacement kind_;
    std::uint64_t lots_;
};

} // namespace ffgpu::work
