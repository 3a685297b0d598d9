// InterpolatorTiming: attributes in time, where a machine's interpolator makes one value of a quad
// a cycle. A quad's divisors (w, 1/q) are made on its way to the unit; then it holds it for
// value_cycles for w and for each attribute that varies, one cycle at least.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/passage.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class InterpolatorTiming final : public Unit {
public:
    struct Ports {
        Channel<QuadToken>& quads_in;
        Channel<QuadToken>& quads_out; // with the unit's latency
    };

    InterpolatorTiming(sc_core::sc_module_name name,
                       const Clock& clock,
                       const InterpolatorConfig& config,
                       const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports) {}

    std::string state() const override;
    // The quads that wait for their values.
    const Passage& passage() const { return passage_; }

private:
    struct Waiting {
        QuadToken quad;
        Cycle ready_at = 0; // Its divisors are there.
        Cycle cycles = 1;   // for its values
        std::uint32_t values = 0;
    };

    Activity step() override;
    Cycle next_work(Activity last) const override;
    bool has_backlog() const override { return Unit::has_backlog() || waiting_.size() > 1; }
    const PieceBox& piece_of(const QuadToken& token);
    void take();
    bool has_place();
    Activity make_values();

    const InterpolatorConfig config_;
    const Ports ports_;
    Passage passage_;
    Ring<Waiting> waiting_;         // The first is the one that values are made of.
    Cycle cycles_left_ = 0;         // of it; 0: not begun
    Ring<std::uint32_t> sent_;      // of each quad on its way to the next unit: its values
    std::uint32_t sent_values_ = 0; // the sum
    std::uint64_t arrived_ = 0;     // quads that the next unit took
    Cycle takes_at_ = 0;            // The divisors' first stage is free.
    std::uint64_t scene_ = 0;       // of the quad that was taken last, and its piece
    std::size_t piece_ = 0;
};

} // namespace ffgpu::timing
