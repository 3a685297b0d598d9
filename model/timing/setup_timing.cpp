#include "model/timing/setup_timing.h"

namespace ffgpu::timing {

std::uint32_t SetupTiming::begin(const PrimitiveToken& token) {
    working_ = true;
    result_ = {token.draw, 0, 0};
    if (token.primitive == PrimitiveToken::None) return config_.setup.reject_cycles;
    const work::PreparedScene& scene = token.draw.scene->work;
    const work::PreparedPrimitive& primitive =
        scene.primitives[token.draw.prepared().first_primitive + token.primitive];
    result_.begin = primitive.first_piece;
    result_.end = primitive.first_piece + primitive.piece_count;
    return primitive.piece_count > 0 ? config_.setup.triangle_cycles * primitive.piece_count
                                     : config_.setup.reject_cycles;
}

Activity SetupTiming::step() {
    if (!working_) {
        if (!ports_.primitives_in.can_pop()) return Activity::Idle;
        const Cycle cycles = begin(ports_.primitives_in.front());
        set_up_at_ = now() + std::max<Cycle>(cycles, 1) - 1;
    }
    if (now() < set_up_at_) return Activity::Busy;
    if (!ports_.setups_out.can_push()) return Activity::StalledOutput;
    result_.last = ports_.primitives_in.pop().last;
    ports_.setups_out.push(result_);
    working_ = false;
    return Activity::Busy;
}

} // namespace ffgpu::timing
