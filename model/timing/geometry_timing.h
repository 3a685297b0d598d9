// GeometryTiming: transform and lighting in time. A vertex that the reuse did not have keeps the
// unit busy for the configured cycles and those of each enabled light; primitives come out behind
// the vertex that completes them.

#pragma once

#include "model/timing/channel.h"
#include "model/timing/config.h"
#include "model/timing/tokens.h"
#include "model/timing/unit.h"

namespace ffgpu::timing {

class GeometryTiming final : public Unit {
public:
    struct Ports {
        Channel<VertexToken>& vertices_in;
        Channel<PrimitiveToken>& primitives_out;
    };

    GeometryTiming(sc_core::sc_module_name name,
                   const Clock& clock,
                   const VertexConfig& config,
                   const Ports& ports)
        : Unit(name, clock)
        , config_(config)
        , ports_(ports) {}

private:
    Activity step() override;
    bool may_sleep() const override { return true; }
    Cycle next_work(Activity last) const override {
        return now() < shaded_at_ ? shaded_at_ : Unit::next_work(last);
    }
    void begin(const VertexToken& vertex);

    const VertexConfig config_;
    const Ports ports_;
    VertexToken vertex_;
    bool shading_ = false;
    Cycle shaded_at_ = 0;                                  // the last cycle that the vertex takes
    std::uint32_t next_primitive_ = 0, end_primitive_ = 0; // to send behind the current vertex
    bool last_vertex_ = false;
    bool ends_draw_ = false; // A draw without primitives sends one token that only ends it.
};

} // namespace ffgpu::timing
