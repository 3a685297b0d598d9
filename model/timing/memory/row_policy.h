// RowPolicy: when a row that nobody waits for is closed.

#pragma once

#include "model/timing/memory/config.h"
#include "model/timing/memory/dram_device.h"

#include <vector>

namespace ffgpu::timing {

class RowPolicy {
public:
    explicit RowPolicy(const MemoryConfig& config)
        : config_(config)
        , conflicts_(config.banks, 1)
        , closed_row_(config.banks, DramDevice::NoRow) {}

    // Whether the access that now goes to `bank` is to close its row behind it. `is_wanted` says
    // whether another request waits for the row.
    template <class IsWanted>
    bool closes_behind(std::uint32_t bank, const IsWanted& is_wanted) const {
        if (config_.page_policy == PagePolicy::Closed) return true;
        return config_.page_policy == PagePolicy::Adaptive && conflicts_[bank] > Neutral &&
               !is_wanted();
    }

    // When an open row that nobody waits for closes.
    MemoryCycle closes_at(MemoryCycle last_column) const {
        return config_.page_policy == PagePolicy::Timeout
                   ? last_column + config_.page_timeout_cycles
                   : NoCycle;
    }

    // A saturating counter a bank learns whether rows left open were of use: a conflict says no, a
    // hit yes, and so does the row that was closed and comes back.
    void learn(std::uint32_t bank, std::uint64_t row, RowResult result) {
        if (config_.page_policy != PagePolicy::Adaptive) return; // Nobody asks.
        const bool closing_is_right = result == RowResult::Conflict ||
                                      (result == RowResult::Miss && closed_row_[bank] != row);
        std::uint8_t& count = conflicts_[bank];
        if (closing_is_right)
            count = static_cast<std::uint8_t>(count + (count < Most));
        else
            count = static_cast<std::uint8_t>(count - (count > 0));
        closed_row_[bank] = row;
    }

private:
    static constexpr std::uint8_t Neutral = 1, Most = 3;

    const MemoryConfig& config_;
    std::vector<std::uint8_t> conflicts_;
    std::vector<std::uint64_t> closed_row_; // the last row of each bank
};

} // namespace ffgpu::timing
