#include "model/timing/setup_timing.h"

namespace ffgpu::timing {

void SetupTiming::begin(const PrimitiveToken& token) {
    working_ = true;
    result_ = {token.draw, 0, 0};
    cycles_left_ = config_.setup.reject_cycles;
    if (token.primitive == PrimitiveToken::None) return;
    const work::PreparedScene& scene = token.draw.scene->work;
    const work::PreparedPrimitive& primitive =
        scene.primitives[token.draw.prepared().first_primitive + token.primitive];
    result_.begin = primitive.first_piece;
    result_.end = primitive.first_piece + primitive.piece_count;
    if (primitive.piece_count > 0)
        cycles_left_ = config_.setup.triangle_cycles * primitive.piece_count;
}

Activity SetupTiming::step() {
    if (!working_) {
        if (!ports_.primitives_in.can_pop()) return Activity::Idle;
        begin(ports_.primitives_in.front());
    }
    if (cycles_left_ > 1) {
        --cycles_left_;
        return Activity::Busy;
    }
    if (!ports_.setups_out.can_push()) return Activity::StalledOutput;
    result_.last = ports_.primitives_in.pop().last;
    ports_.setups_out.push(result_);
    working_ = false;
    return Activity::Busy;
}

bool SetupTiming::may_sleep() const {
    return !working_ && ports_.primitives_in.holds_nothing();
}

} // namespace ffgpu::timing
