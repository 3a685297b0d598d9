// CounterChanges, HistogramChanges: what counters and histograms counted since they were looked at
// last.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/histogram.h"
#include "model/work/frame_figures.h"

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ffgpu::tools {

class CounterChanges {
public:
    work::Figures take(const std::vector<const StatisticsGroup*>& groups) {
        work::Figures changes;
        for (const StatisticsGroup* const group : groups)
            for (const Counter& counter : group->counters()) {
                std::uint64_t& before = before_[std::string(counter.name())];
                changes.emplace_back(counter.name(), counter.value() - before);
                before = counter.value();
            }
        return changes;
    }

private:
    std::map<std::string, std::uint64_t> before_;
};

// By name.
using HistogramCounts = std::vector<std::pair<std::string, std::vector<std::uint64_t>>>;

class HistogramChanges {
public:
    HistogramCounts take(const std::vector<const timing::Histogram*>& histograms) {
        HistogramCounts changes;
        for (const timing::Histogram* const histogram : histograms) {
            std::vector<std::uint64_t>& before = before_[histogram->name()];
            std::vector<std::uint64_t> counts = histogram->counts();
            before.resize(counts.size());
            for (std::size_t i = 0; i < counts.size(); ++i)
                counts[i] -= std::exchange(before[i], counts[i]);
            changes.emplace_back(histogram->name(), std::move(counts));
        }
        return changes;
    }

private:
    std::map<std::string, std::vector<std::uint64_t>> before_;
};

} // namespace ffgpu::tools
