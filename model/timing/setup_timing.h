// SetupTiming: clipping, culling and triangle set-up in time. Each piece of a primitive costs
// triangle_cycles, whether it covers a pixel centre or not; a primitive that was culled or clipped
// away costs reject_cycles.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/in_flight.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class SetupTiming final : public Unit {
public:
    struct Ports {
        Channel<PrimitiveToken>& primitives_in;
        Channel<SetupToken>& setups_out;
    };

    SetupTiming(sc_core::sc_module_name name,
                const Clock& clock,
                const TimingConfig& config,
                const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports) {}

private:
    Activity step() override;
    bool may_sleep() const override;
    void begin(const PrimitiveToken& primitive);

    const TimingConfig& config_;
    const Ports ports_;
    bool working_ = false;
    std::uint32_t cycles_left_ = 0;
    SetupToken result_;
};

} // namespace ffgpu::timing
