// DepthTiming: depth and stencil tests in time, before texturing where the draw allows it and after
// the fragment stages where not. One unit, one cache, two paths; the late path goes first. Quads of
// the other kind pass through.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/in_flight.h"
#include "model/timing/parked_quads.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class DepthTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& early_in;
        Channel<QuadToken>& early_out;
        Channel<QuadToken>& late_in;
        Channel<QuadToken>& late_out;
        Channel<std::uint64_t>& responses_in;
        LineCache& cache;
    };

    DepthTiming(sc_core::sc_module_name name,
                const Clock& clock,
                const TimingConfig& config,
                const Ports& ports,
                InFlight& in_flight);

private:
    enum class Path { Early, Late };

    Activity step() override;
    bool may_sleep() const override { return true; }
    bool look_up(Path path, std::uint32_t& lookups_left, Activity& reason);
    bool send(Path path, Activity& reason);

    const TimingConfig& config_;
    const Ports ports_;
    InFlight& in_flight_;
    ParkedQuads early_, late_;
    LineWalk early_walk_, late_walk_; // of the quads that are looked up
};

} // namespace ffgpu::timing
