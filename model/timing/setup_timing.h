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
    bool may_sleep() const override { return true; }
    Cycle next_work(Activity last) const override {
        return now() < set_up_at_ ? set_up_at_ : Unit::next_work(last);
    }
    // Returns the cycles that the primitive takes.
    std::uint32_t begin(const PrimitiveToken& primitive);

    const TimingConfig& config_;
    const Ports ports_;
    bool working_ = false;
    Cycle set_up_at_ = 0; // the last cycle that the primitive takes
    SetupToken result_;
};

} // namespace ffgpu::timing
