// RasterTiming: makes quads, quads_per_cycle of them, and steps from traversal tile to tile. An
// immediate machine follows the primitives; a tile-based one first takes in all primitives of a
// scene and then walks it screen bin by screen bin.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/in_flight.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class RasterTiming final : public Unit {
public:
    struct Ports {
        Channel<SetupToken>& setups_in;
        Channel<QuadToken>& quads_out;
    };

    RasterTiming(sc_core::sc_module_name name,
                 const Clock& clock,
                 const RasterConfig& config,
                 const Ports& ports,
                 InFlight& in_flight)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports)
        , in_flight_(in_flight) {}

private:
    Activity step() override;
    bool may_sleep() const override { return true; }
    void take(const SetupToken& token);

    const RasterConfig config_;
    const Ports ports_;
    InFlight& in_flight_;
    TimedScene* scene_ = nullptr;
    std::uint32_t next_ = 0, end_ = 0;
    std::uint32_t tile_cycles_left_ = 0;
    bool tile_begun_ = false;
    std::uint32_t draws_taken_ = 0; // tile-based: of the scene
};

} // namespace ffgpu::timing
