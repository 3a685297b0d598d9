// FragmentTiming: texture environments, colour sum, fog and alpha test in time. A quad takes
// combiner_cycles for each enabled environment, at least one; quads_per_cycle pipes work side by
// side.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class FragmentTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& quads_in;
        Channel<QuadToken>& quads_out; // with the unit's latency
    };

    FragmentTiming(sc_core::sc_module_name name,
                   const Clock& clock,
                   const TimingConfig& config,
                   const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports) {}

private:
    Activity step() override;
    bool may_sleep() const override { return cycles_left_ == 0 && ports_.quads_in.holds_nothing(); }

    const TimingConfig& config_;
    const Ports ports_;
    std::uint32_t cycles_left_ = 0; // before the pipes take quads again
};

} // namespace ffgpu::timing
