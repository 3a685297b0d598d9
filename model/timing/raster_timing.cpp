#include "model/timing/raster_timing.h"

namespace ffgpu::timing {
void RasterTiming::take(const SetupToken& token) {
    bin_ = token.draw.bin;
    if (config_.architecture == Architecture::Immediate) {
        next_ = token.begin;
        end_ = token.end;
    } else if (const Segment& segment = bin_->segments[token.draw.prepared().segment];
               token.last && ++draws_taken_ == segment.draws) {
        next_ = segment.quads_begin;
        end_ = segment.quads_end;
        draws_taken_ = 0;
    }
    in_flight_.enter(end_ - next_);
    if (token.last) { // The draw itself is through: its quads are counted now.
        in_flight_.leave();
        ++bin_->finished_draws;
    }
}

Activity RasterTiming::step() {
    if (next_ == end_) {
        if (!ports_.setups_in.can_pop()) return Activity::Idle;
        take(ports_.setups_in.pop());
        if (next_ == end_) return Activity::Busy;
    }
    for (std::uint32_t i = 0; i < config_.quads_per_cycle && next_ < end_; ++i) {
        if (bin_->quads[next_].new_tile && !tile_begun_) {
            tile_begun_ = true;
            tile_cycles_left_ = config_.tile_cycles;
        }
        if (tile_cycles_left_ > 0) {
            --tile_cycles_left_;
            return Activity::Busy;
        }
        if (!ports_.quads_out.can_push()) return i > 0 ? Activity::Busy : Activity::StalledOutput;
        ports_.quads_out.push({bin_, next_, 0});
        tile_begun_ = false;
        ++next_;
    }
    return Activity::Busy;
}

bool RasterTiming::may_sleep() const {
    return next_ == end_ && ports_.setups_in.holds_nothing();
}

} // namespace ffgpu::timing
