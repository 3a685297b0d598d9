#include "model/timing/setup_timing.h"

namespace ffgpu::timing {

void SetupTiming::begin(const PrimitiveToken& token) {
    const PreparedDraw& draw = token.draw.prepared();
    if (token.draw.scene != current_.scene || token.draw.draw != current_.draw) {
        current_ = token.draw;
        next_quad_ = draw.first_quad;
        empty_set_up_ = 0;
    }
    working_ = true;
    result_ = {token.draw, next_quad_, next_quad_};
    if (config_.raster.architecture ==
        Architecture::TileBased) { // Quads are the scene's, in its order.
        cycles_left_ = config_.setup.triangle_cycles;
        return;
    }
    const auto& quads = token.draw.scene->work.quads;
    const std::uint32_t draw_end = draw.first_quad + draw.quad_count;
    const std::uint32_t key_end = draw.keys_before(token.primitive + 1);
    const auto belongs = [&](std::uint32_t quad) {
        return quad < draw_end && (token.last || quads[quad].primitive < key_end);
    };
    while (belongs(result_.end))
        ++result_.end;
    next_quad_ = result_.end;
    if (result_.end > result_.begin) {
        cycles_left_ = config_.setup.triangle_cycles;
        return;
    }
    const GeometryWork& work = draw.geometry;
    const std::uint32_t empty = work.primitives_out > draw.primitives_with_quads
                                    ? work.primitives_out - draw.primitives_with_quads
                                    : 0;
    const bool set_up = empty_set_up_ < empty;
    empty_set_up_ += set_up;
    cycles_left_ = set_up ? config_.setup.triangle_cycles : config_.setup.reject_cycles;
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
    if (result_.last) current_ = {};
    ports_.setups_out.push(result_);
    working_ = false;
    return Activity::Busy;
}

bool SetupTiming::may_sleep() const {
    return !working_ && ports_.primitives_in.holds_nothing();
}

} // namespace ffgpu::timing
