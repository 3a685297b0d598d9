// SetupTiming: culling and set-up in time, by units side by side. Each piece of a primitive takes a
// unit triangle_cycles and its attributes' cycles, whether it covers a pixel centre or not; a
// primitive without pieces takes reject_cycles. Records leave in the order of the primitives: a
// unit keeps its own until it is their turn.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/passage.h"
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

    std::string state() const override;
    // Through the units.
    const Passage& passage() const { return passage_; }

private:
    struct InUnit {
        SetupToken record;
        Cycle done_at = 0; // the last cycle that it takes
    };

    Activity step() override;
    Cycle next_work(Activity last) const override {
        return now() < next_change_ ? next_change_ : Unit::next_work(last);
    }
    Cycle piece_cycles(const SetupToken& record) const;
    bool drops(const SetupToken& record) const;
    void sleep_until_done();
    bool begin_next();
    bool send_next();

    const TimingConfig& config_;
    const Ports ports_;
    Ring<InUnit> units_;           // those that work, in the order of the primitives
    Passage passage_;              // through them
    Cycle next_change_ = 0;        // where nothing moved: a unit is done
    std::uint32_t next_piece_ = 0; // of the first primitive that waits
};

} // namespace ffgpu::timing
