// ColorTiming: blending and the colour cache in time; the end of a quad's way. Lines that are only
// written are not fetched.

#pragma once

#include "model/timing/block_states.h"
#include "model/timing/channel.h"
#include "model/timing/in_flight.h"
#include "model/timing/parked_quads.h"
#include "model/timing/quad_observer.h"
#include "model/timing/target_interlock.h"
#include "model/timing/unit.h"

#include <functional>

namespace ffgpu::timing {

class ColorTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& quads_in;
        Channel<std::uint64_t>& responses_in;
        LineCache& cache;
        BlockStates* blocks; // null: values are not followed
    };

    // `on_retire` sees each quad that reaches the end, and the cycle.
    ColorTiming(sc_core::sc_module_name name,
                const Clock& clock,
                const TimingConfig& config,
                const Ports& ports,
                InFlight& in_flight,
                std::function<void(const QuadToken&, Cycle)> on_retire);

    std::string state() const override;

    void set_observer(QuadObserver* observer) { observer_ = observer; } // or null
    // The quads that wait for their colours.
    const ParkedQuads& quads() const { return parked_; }

private:
    Activity step() override;
    bool look_up(Activity& reason);
    bool read_pixels(Activity& reason);
    void store_pixels(const QuadToken& token);
    Cycle next_work(Activity last) const override;
    void follow_values(const QuadToken& token, std::uint64_t line);
    bool retire(Activity& reason);

    const TimingConfig& config_;
    const Ports ports_;
    InFlight& in_flight_;
    std::function<void(const QuadToken&, Cycle)> on_retire_;
    ParkedQuads parked_;
    LineWalk walk_;             // of the quad that is looked up
    TargetInterlock interlock_; // without a cache
    QuadObserver* observer_ = nullptr;
};

} // namespace ffgpu::timing
