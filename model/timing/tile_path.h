// TilePath: the units that only a tile-based machine has, between set-up and rasterizer, with their
// links and their ports to memory.

#pragma once

#include "model/timing/bottlenecks.h"
#include "model/timing/cache_port.h"
#include "model/timing/memory_arbiter.h"
#include "model/timing/parameter_fetch.h"
#include "model/timing/tile_binner.h"
#include "model/timing/tile_memory.h"

#include <vector>

namespace ffgpu::timing {

class TilePath {
public:
    struct Ports {
        Channel<SetupToken>& setups_in;
        Channel<BinToken>& bins_out;
        InFlight& in_flight;
        InFlight& memory_in_flight;
    };

    TilePath(const Clock& clock, const TimingConfig& config, const Ports& ports);

    // The units at its two ends, and the memory's.
    void connect(Unit& setup, Unit& raster, Unit& arbiter);
    void add_to(MemoryArbiter::Ports& arbiter);
    std::vector<Unit*> units() { return {&binner_, &fetch_, &memory_}; }
    std::vector<Stage> stages() {
        return {{.resource = Resource::Binner, .unit = &binner_},
                {.resource = Resource::ParameterFetch, .unit = &fetch_},
                {.resource = Resource::TileMemory, .unit = &memory_}};
    }
    std::vector<const StatisticsGroup*> statistics() const {
        return {&binner_.statistics(), &memory_.statistics()};
    }

private:
    const Ports ports_;
    RequestPort binner_requests_, fetch_requests_, memory_requests_;
    Channel<std::uint64_t> fetch_responses_, memory_responses_;
    Channel<PassToken> passes_;
    Channel<BinToken> fetched_bins_;
    Channel<std::uint32_t> free_buffers_;
    TileBinner binner_;
    ParameterFetch fetch_;
    TileMemory memory_;
};

} // namespace ffgpu::timing
