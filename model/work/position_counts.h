// PositionCounts: how many look-ups found their line at which position of its set's stack, of 2, 4,
// 8 ... sets, by where the line was used last.

#pragma once

#include "model/work/lookups.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ffgpu::work {

// Counts by position.
using Histogram = std::vector<std::uint64_t>;
using ReuseHistograms = std::array<Histogram, ReuseScopes + 1>;

class PositionCounts {
public:
    // Positions from most_ways on are one.
    PositionCounts(std::size_t levels, std::uint32_t most_ways)
        : levels_(levels)
        , positions_(most_ways + 1)
        , counts_(levels * (ReuseScopes + 1) * positions_, 0)
        , in_both_(levels * positions_, 0) {}

    std::size_t levels() const { return levels_; }

    // Of one line, in 2, 4, 8 ... sets; positions up to most_ways.
    void add(std::span<const std::uint32_t> positions,
             Reuse reuse,
             std::uint32_t depth,
             std::uint64_t times) {
        std::uint64_t* counts = counts_.data() + begin(0, reuse);
        std::uint64_t* in_both = in_both_.data();
        for (const std::uint32_t position : positions) {
            depth /= 2;
            counts[position] += times;
            in_both[std::min(position, depth)] += times;
            counts += (ReuseScopes + 1) * positions_;
            in_both += positions_;
        }
    }
    // In 2^(level + 1) sets, of a line at `depth` among all.
    void add(std::size_t level,
             Reuse reuse,
             std::uint32_t position,
             std::uint32_t depth,
             std::uint64_t times) {
        const std::uint32_t own = std::min(position, positions_ - 1);
        counts_[begin(level, reuse) + own] += times;
        in_both_[level * positions_ + std::min(own, depth >> (level + 1))] += times;
    }

    PositionCounts& operator+=(const PositionCounts& other) {
        const auto add = [](Histogram& to, const Histogram& from) {
            std::transform(to.begin(), to.end(), from.begin(), to.begin(), std::plus<>());
        };
        add(counts_, other.counts_);
        add(in_both_, other.in_both_);
        return *this;
    }

    ReuseHistograms positions(std::size_t level) const {
        ReuseHistograms of;
        for (std::size_t reuse = 0; reuse < of.size(); ++reuse)
            of[reuse] = part(counts_, begin(level, static_cast<Reuse>(reuse)));
        return of;
    }
    // Of the lesser of position and what is over of the sets' share.
    Histogram in_both(std::size_t level) const { return part(in_both_, level * positions_); }

private:
    std::size_t begin(std::size_t level, Reuse reuse) const {
        return (level * (ReuseScopes + 1) + static_cast<std::size_t>(reuse)) * positions_;
    }
    Histogram part(const Histogram& of, std::size_t begin) const {
        const auto first = of.begin() + static_cast<std::ptrdiff_t>(begin);
        return {first, first + positions_};
    }

    std::size_t levels_;
    std::uint32_t positions_;
    Histogram counts_, in_both_;
};

} // namespace ffgpu::work
