#include "model/timing/raster_timing.h"

namespace ffgpu::timing {
void RasterTiming::take(const SetupToken& token) {
    scene_ = token.draw.scene;
    if (config_.architecture == Architecture::Immediate) {
        const auto& pieces = scene_->work.pieces;
        next_ = token.begin == token.end ? 0 : pieces[token.begin].begin;
        end_ = token.begin == token.end ? 0 : pieces[token.end - 1].end;
    } else if (token.last && ++draws_taken_ == scene_->work.draws.size()) {
        next_ = 0;
        end_ = static_cast<std::uint32_t>(scene_->work.quads.size());
        draws_taken_ = 0;
    }
    in_flight_.enter(end_ - next_);
    if (token.last) { // The draw itself is through: its quads are counted now.
        in_flight_.leave();
        scene_->end_draw(token.draw.draw, now());
    }
}

Activity RasterTiming::step() {
    if (next_ == end_) {
        if (!ports_.setups_in.can_pop()) return Activity::Idle;
        take(ports_.setups_in.pop());
        if (next_ == end_) return Activity::Busy;
    }
    for (std::uint32_t i = 0; i < config_.quads_per_cycle && next_ < end_; ++i) {
        if (scene_->work.quads[next_].new_tile && !tile_begun_) {
            tile_begun_ = true;
            tile_cycles_left_ = config_.tile_cycles;
        }
        if (tile_cycles_left_ > 0) {
            --tile_cycles_left_;
            return Activity::Busy;
        }
        if (!ports_.quads_out.can_push()) return i > 0 ? Activity::Busy : Activity::StalledOutput;
        ports_.quads_out.push({scene_, next_, 0});
        tile_begun_ = false;
        ++next_;
    }
    return Activity::Busy;
}

} // namespace ffgpu::timing
