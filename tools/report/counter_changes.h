// CounterChanges: what counters counted since they were looked at last.

#pragma once

#include "model/base/statistics.h"
#include "model/work/frame_figures.h"

#include <cstdint>
#include <map>
#include <string>
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

} // namespace ffgpu::tools
