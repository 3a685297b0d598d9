// MemoryObserver: is told of each request that goes to memory. It never changes a cycle.

#pragma once

#include "model/timing/memory_request.h"

#include <cstdint>

namespace ffgpu::timing {

class MemoryObserver {
public:
    virtual ~MemoryObserver() = default;
    // The arbiter sends it, in this cycle since the machine's start; in their order.
    virtual void sent(const MemoryRequest& request, std::uint64_t cycle) = 0;
    // Its data are there, or written: it counts in the statistics.
    virtual void done(const MemoryRequest& request, std::uint64_t cycle) = 0;
};

} // namespace ffgpu::timing
