#pragma once

#include "model/timing/memory/dram_channel.h"

namespace ffgpu::timing {

// For tests that look at the channel's own answers.
class NobodyWatches : public DramObserver {
    void on_access(std::uint32_t, const DramRequest&, RowResult) override {}
    void on_data(MemoryCycle) override {}
    void on_lost(LostTo, MemoryCycle) override {}
    void on_turnaround() override {}
    void on_refresh() override {}
};

} // namespace ffgpu::timing
