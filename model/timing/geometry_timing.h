// GeometryTiming: transform and lighting in time, by units side by side, and the assembly of
// primitives behind them. A vertex that the reuse did not have keeps a unit busy for the configured
// cycles and those of each enabled light. Vertices leave in their order, each with the primitives
// that it completes.

#pragma once

#include "model/base/ring.h"
#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/passage.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

#include <vector>

namespace ffgpu::timing {

class GeometryTiming final : public Unit {
public:
    struct Ports {
        Channel<VertexToken>& vertices_in;
        Channel<PrimitiveToken>& primitives_out;
    };

    GeometryTiming(sc_core::sc_module_name name,
                   const Clock& clock,
                   const TimingConfig& config,
                   const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports)
        , free_at_(config.vertex.units) {}

    std::string state() const override;
    // From a vertex' begin to its last primitive.
    const Passage& passage() const { return passage_; }

private:
    struct Shaded {
        VertexToken vertex;
        Cycle done_at = 0; // the last cycle that it takes
    };

    Activity step() override;
    Cycle next_work(Activity last) const override {
        return now() < next_change_ ? next_change_ : Unit::next_work(last);
    }
    void sleep_until_done();
    bool begin_next();
    void assemble(const VertexToken& vertex);
    bool send_next();

    const TimingConfig& config_;
    const Ports ports_;
    std::vector<Cycle> free_at_; // of each unit
    Ring<Shaded> order_;         // vertices in the units, and those that wait for their turn
    Passage passage_;            // through these

    Cycle next_change_ = 0; // where nothing moved: a unit is done

    // Of the vertex that leaves.
    bool assembling_ = false;
    bool ends_draw_ = false; // No primitive is left to tell the draw's end.
    std::uint32_t next_primitive_ = 0, end_primitive_ = 0;
};

} // namespace ffgpu::timing
