// ClipTiming: the clipper in time. What needs no cut passes; a primitive that is cut keeps the unit
// for plane_cycles a plane; one of which nothing is left ends here, or only tells its draw's end.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class ClipStatistics : public StatisticsGroup {
public:
    Counter& clipped = count("clip_primitives", "primitives", "cut against a plane");
    Counter& planes = count("clip_planes", "planes", "that primitives were cut against");
    Counter& outside = count("clip_outside", "primitives", "of which nothing was left");
};

class ClipTiming final : public Unit {
public:
    struct Ports {
        Channel<PrimitiveToken>& primitives_in;
        Channel<PrimitiveToken>& primitives_out;
    };

    ClipTiming(sc_core::sc_module_name name,
               const Clock& clock,
               const TimingConfig& config,
               const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports) {}

    std::string state() const override;
    const ClipStatistics& statistics() const { return statistics_; }

private:
    Activity step() override;
    Cycle next_work(Activity last) const override {
        return working_ && now() < clipped_at_ ? clipped_at_ : Unit::next_work(last);
    }
    void begin(const PrimitiveToken& token);

    const TimingConfig& config_;
    const Ports ports_;
    ClipStatistics statistics_;
    bool working_ = false; // on the first primitive that waits
    Cycle clipped_at_ = 0; // the last cycle that it takes
    bool outside_ = false;
};

} // namespace ffgpu::timing
