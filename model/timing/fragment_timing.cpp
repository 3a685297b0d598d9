#include "model/timing/fragment_timing.h"

#include <algorithm>

namespace ffgpu::timing {

Activity FragmentTiming::step() {
    if (cycles_left_ > 0) {
        --cycles_left_;
        return Activity::Busy;
    }
    Activity activity = Activity::Idle;
    for (std::uint32_t i = 0; i < config_.raster.quads_per_cycle && ports_.quads_in.can_pop();
         ++i) {
        if (!ports_.quads_out.can_push()) return i > 0 ? Activity::Busy : Activity::StalledOutput;
        const QuadToken token = ports_.quads_in.pop();
        const std::uint32_t cycles = token.draw().combiners * config_.fragment.combiner_cycles;
        cycles_left_ = std::max(cycles_left_, std::max(cycles, 1u) - 1);
        ports_.quads_out.push(token);
        activity = Activity::Busy;
    }
    return activity;
}

} // namespace ffgpu::timing
