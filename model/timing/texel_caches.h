// TexelCaches: the texel caches of the machine as configured: one that all fragment pipes share or
// one for each, and behind them, if it is there, the second level.

#pragma once

#include "model/timing/memory_arbiter.h"
#include "model/timing/texel_l2.h"

#include <deque>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::timing {

class TexelCaches {
public:
    TexelCaches(const Clock& clock, const TimingConfig& config, InFlight& memory_in_flight);

    // What the texture units see: one, or one for each pipe.
    std::vector<CachePort*> first_level();
    // Null where there is none.
    LineCache* second_level() { return l2_port_ ? &l2_port_->cache : nullptr; }
    // What the memory sees.
    std::vector<CachePort*> at_memory();
    // The second level's unit; null where there is none.
    TexelL2* unit() { return l2_.get(); }
    // What it asks the memory by.
    const CachePort& second_level_port() const { return *l2_port_; }

    void connect(Unit& texture, Unit& arbiter);

    // Brings the sums over the pipes' caches up to date.
    void settle();
    std::vector<const StatisticsGroup*> statistics() const;

private:
    CachePort& add(const Clock& clock, const TimingConfig& config, InFlight& in_flight);

    std::deque<std::string> names_;
    std::deque<CachePort> first_level_;
    std::unique_ptr<CacheStatistics> sum_; // over several first-level caches
    std::unique_ptr<CachePort> l2_port_;
    std::unique_ptr<TexelL2> l2_;
};

} // namespace ffgpu::timing
