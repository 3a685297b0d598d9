// PositionCounts: how many look-ups found their line at which position of its set's stack, of 2, 4,
// 8 ... sets, by where the line was used last.

#pragma once

#include "model/work/lookups.h"

#include <algorithm>
#include <functional>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::work {

// Counts by position; the last of a set's stack are all deeper ones.
using Histogram = std::vector<std::uint64_t>;
using ReuseHistograms = std::array<Histogram, ReuseScopes + 1>;

class PositionCounts {
public:
    // Of one number of sets.
    struct Level {
        ReuseHistograms positions;
        Histogram in_both; // the lesser of position and what is over of the sets' share
    };

    PositionCounts(std::size_t levels, std::uint32_t most_ways)
        : levels_(levels) {
        for (Level& level : levels_) {
            for (Histogram& histogram : level.positions)
                histogram.assign(std::size_t{most_ways} + 1, 0);
            level.in_both.assign(std::size_t{most_ways} + 1, 0);
        }
    }

    std::size_t size() const { return levels_.size(); }
    const Level& operator[](std::size_t level) const { return levels_[level]; }

    // In 2^(level + 1) sets, of a line at `depth` among all.
    void add(std::size_t level,
             Reuse reuse,
             std::uint32_t position,
             std::uint32_t depth,
             std::uint64_t times) {
        Level& to = levels_[level];
        const std::size_t last = to.in_both.size() - 1;
        const std::size_t own = std::min<std::size_t>(position, last);
        to.positions[static_cast<std::size_t>(reuse)][own] += times;
        to.in_both[std::min<std::size_t>(own, depth >> (level + 1))] += times;
    }

    PositionCounts& operator+=(const PositionCounts& other) {
        const auto add = [](Histogram& to, const Histogram& from) {
            std::transform(to.begin(), to.end(), from.begin(), to.begin(), std::plus<>());
        };
        for (std::size_t level = 0; level < levels_.size(); ++level) {
            add(levels_[level].in_both, other[level].in_both);
            for (std::size_t reuse = 0; reuse <= ReuseScopes; ++reuse)
                add(levels_[level].positions[reuse], other[level].positions[reuse]);
        }
        return *this;
    }

private:
    std::vector<Level> levels_;
};

} // namespace ffgpu::work
