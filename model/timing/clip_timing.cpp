#include "model/timing/clip_timing.h"

namespace ffgpu::timing {

void ClipTiming::begin(const PrimitiveToken& token) {
    working_ = true;
    clipped_at_ = now();
    outside_ = false;
    if (token.primitive == PrimitiveToken::None) return;
    const work::PreparedPrimitive& primitive = token.prepared();
    outside_ = primitive.fate == PrimitiveFate::Outside;
    statistics_.outside += outside_;
    if (primitive.planes == 0) return;
    ++statistics_.clipped;
    statistics_.planes += primitive.planes;
    const Cycle cycles = Cycle{primitive.planes} * config_.clip.plane_cycles;
    if (cycles > 0) clipped_at_ = now() + cycles - 1;
}

Activity ClipTiming::step() {
    for (std::uint32_t moved = 0; moved < config_.setup.units; ++moved) {
        if (!ports_.primitives_in.can_pop()) return moved > 0 ? Activity::Busy : Activity::Idle;
        PrimitiveToken token = ports_.primitives_in.front();
        if (!working_) begin(token);
        if (now() < clipped_at_) return Activity::Busy;
        const bool goes_on = !outside_ || token.last;
        if (goes_on && !ports_.primitives_out.can_push())
            return moved > 0 ? Activity::Busy : Activity::StalledOutput;
        ports_.primitives_in.pop();
        if (outside_) token.primitive = PrimitiveToken::None;
        if (goes_on) ports_.primitives_out.push(token);
        working_ = false;
    }
    return Activity::Busy;
}

} // namespace ffgpu::timing
