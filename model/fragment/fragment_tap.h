// What the fragment pipe tells a stage probe. Without one (a null tap) the functions are the
// stages.

#pragma once

#include "model/fragment/fragment_pipe.h"
#include "model/packets/stage_probe.h"

namespace ffgpu {

// Around the stages that make batch.color.
class ShadeTap {
public:
    explicit ShadeTap(const ProbeTap* tap)
        : tap_(tap) {}

    // Before the stage: what goes in.
    void enters(const ColorPlanes& color) {
        if (tap_) before_ = color;
    }
    // Behind it.
    void environment(unsigned unit) const {
        if (tap_) tap_->probe.environment(tap_->batch, {.unit = unit, .previous = &before_});
    }
    void color_sum() const {
        if (tap_) tap_->probe.color_sum(tap_->batch, before_);
    }
    void fog(const FogCurve& curve) const {
        if (tap_) tell_fog(curve);
    }
    void antialias() const {
        if (tap_) tap_->probe.antialias(tap_->batch, before_);
    }

private:
    void tell_fog(const FogCurve& curve) const;

    const ProbeTap* tap_;
    ColorPlanes before_; // with a tap
};

FragmentMask
run_alpha_test(const FragmentPipe& pipe, const FragmentBatch& batch, const ProbeTap* tap);

// The visit of batch.live to one sample's plane of the depth target.
StencilDepthFates run_depth_test(const FragmentPipe& pipe,
                                 unsigned sample,
                                 const FragmentBatch& batch,
                                 const ProbeTap* tap);

// batch.live into one sample's plane of every colour target.
void run_color_write(const FragmentPipe& pipe,
                     unsigned sample,
                     const FragmentBatch& batch,
                     const ProbeTap* tap);

} // namespace ffgpu
