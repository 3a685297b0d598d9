// TexelL2: the second-level texel cache, between the first-level caches and memory. Requests of a
// first-level cache wait in its own queue until their data are there, and are answered in order; no
// cache waits for another's misses. Each is answered over a link of its own.

#pragma once

#include "model/timing/cache_port.h"
#include "model/timing/passage.h"
#include "model/timing/unit.h"

#include <deque>
#include <vector>

namespace ffgpu::timing {

class TexelL2 final : public Unit {
public:
    struct Ports {
        std::vector<CachePort*> first_level; // their requests come in, their responses go out
        CachePort& memory;                   // the cache itself, and its way to memory
    };

    TexelL2(sc_core::sc_module_name name,
            const Clock& clock,
            const TexelL2Config& config,
            const Ports& ports,
            InFlight& memory_in_flight);

    std::string state() const override;
    // Of each first-level cache: its requests that were looked up.
    const Passage& waiting(std::size_t client) const { return queues_[client].passage; }

private:
    struct Waiting {
        std::uint64_t ticket = 0;  // of this cache's fill
        std::uint64_t request = 0; // of the first-level cache's
        std::uint32_t bytes = 0;
    };
    struct Queue {
        std::deque<Waiting> waiting;
        std::uint32_t transfer_cycles_left = 0; // of the oldest, once it is on the link
        Passage passage;
    };

    Activity step() override;
    bool answer(std::size_t client, Activity& reason);
    bool look_up(std::size_t client, Activity& reason);

    const TexelL2Config config_;
    const Ports ports_;
    InFlight& memory_in_flight_;
    std::vector<Queue> queues_;
    std::size_t first_ = 0; // client at the tags
};

} // namespace ffgpu::timing
