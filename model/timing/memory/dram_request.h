// What a DRAM channel is asked for, and who is told about it.

#pragma once

#include "model/timing/memory/lost_cycles.h"

#include <cstdint>

namespace ffgpu::timing {

struct DramRequest {
    std::uint32_t bank = 0;
    std::uint64_t row = 0;
    std::uint32_t offset = 0; // in the row, of the first byte
    std::uint32_t bytes = 0;
    bool write = false;
    std::uint32_t client = 0; // for the observer
    void* payload = nullptr;  // the caller's
};

// What a request found in its bank: its row, no row, or another one.
enum class RowResult : std::uint8_t { Hit, Miss, Conflict, Count };

// The statistics of whoever owns the channels.
class DramObserver {
public:
    virtual ~DramObserver() = default;
    virtual void on_access(std::uint32_t channel, const DramRequest& request, RowResult result) = 0;
    virtual void on_data(MemoryCycle cycles) = 0;
    virtual void on_lost(LostTo cause, MemoryCycle cycles) = 0;
    virtual void on_turnaround() = 0;
    virtual void on_refresh() = 0;
};

} // namespace ffgpu::timing
