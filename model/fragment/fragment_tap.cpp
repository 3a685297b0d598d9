#include "model/fragment/fragment_tap.h"

#include "model/fragment/depth_target.h"
#include "model/fragment/lane_access.h"

#include <memory>

namespace ffgpu {
namespace {

template <class Visit>
void for_lanes(const FragmentMask& mask, const FragmentBatch& batch, Visit&& visit) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        if (mask.test(lane)) visit(lane, lane_position(batch, lane));
}

void load_depths(const FragmentPipe& pipe,
                 const probed::StencilDepth& test,
                 const FragmentBatch& batch,
                 probed::Lanes<std::uint32_t>& depths,
                 probed::Lanes<std::uint8_t>& stencils) {
    const Surface plane = pipe.depth_target.plane(test.sample);
    if (plane.format == Format::None) return;
    for_lanes(test.before, batch, [&](unsigned lane, LanePosition at) {
        const StencilDepthPixel pixel =
            load_stencil_depth(plane.format, pixel_address(plane, pipe.memory, at.x, at.y));
        depths[lane] = pixel.depth;
        stencils[lane] = pixel.stencil;
    });
}

StencilDepthFates
depth_test(const FragmentPipe& pipe, unsigned sample, const FragmentBatch& batch) {
    return pipe.stages->test_depth_target(
        pipe.stencil_depth, pipe.depth_target.plane(sample), batch, pipe.memory);
}

StencilDepthFates told_depth_test(const FragmentPipe& pipe,
                                  unsigned sample,
                                  const FragmentBatch& batch,
                                  const ProbeTap& tap) {
    const auto test = std::make_unique<probed::StencilDepth>();
    test->sample = sample;
    test->early = pipe.early_depth;
    test->on = pipe.stencil_depth.active();
    test->before = batch.live;
    load_depths(pipe, *test, batch, test->stored_depth, test->stored_stencil);
    const StencilDepthFates fates = depth_test(pipe, sample, batch);
    load_depths(pipe, *test, batch, test->new_depth, test->new_stencil);
    test->after_stencil = fates.after_stencil;
    test->after_depth = fates.after_depth;
    tap.probe.stencil_depth(tap.batch, *test);
    return fates;
}

void load_colors(const FragmentPipe& pipe,
                 const Surface& plane,
                 const FragmentBatch& batch,
                 probed::Lanes<std::uint32_t>& colors) {
    for_lanes(batch.live, batch, [&](unsigned lane, LanePosition at) {
        colors[lane] = load_rgba8(plane.format, pixel_address(plane, pipe.memory, at.x, at.y));
    });
}

void tell_color_write(const FragmentPipe& pipe,
                      probed::ColorWrite& told,
                      const FragmentBatch& batch,
                      const ProbeTap& tap) {
    const ColorTarget& target = pipe.color_targets[told.target];
    const ColorTarget plane{target.surface.plane(told.sample), target.write_mask, target.srgb};
    told.written = batch.live;
    load_colors(pipe, plane.surface, batch, told.destination);
    for_lanes(batch.live, batch, [&](unsigned lane, LanePosition) {
        told.blended[lane] = pack_rgba8(blended_color(pipe.color_stage,
                                                      target.srgb,
                                                      lane_color(batch.color, lane),
                                                      unpack_rgba8(told.destination[lane])));
    });
    pipe.stages->write_color(pipe.color_stage, plane, batch, pipe.memory);
    load_colors(pipe, plane.surface, batch, told.stored);
    tap.probe.color_write(tap.batch, told);
}

} // namespace

void ShadeTap::tell_fog(const FogCurve& curve) const {
    const auto fog = std::make_unique<probed::Fog>();
    fog->before = &before_;
    const FragmentBatch& batch = *tap_->batch.fragments;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        fog->factor[lane] = fog_factor(curve, batch.fog_coordinate[lane]);
    tap_->probe.fog(tap_->batch, *fog);
}

FragmentMask
run_alpha_test(const FragmentPipe& pipe, const FragmentBatch& batch, const ProbeTap* tap) {
    const FragmentControl& control = pipe.registers->fragment;
    const FragmentMask passed = pipe.stages->alpha_test(control, batch);
    if (tap) tap->probe.alpha_test(tap->batch, {control.alpha_test, batch.live, passed});
    return passed;
}

StencilDepthFates run_depth_test(const FragmentPipe& pipe,
                                 unsigned sample,
                                 const FragmentBatch& batch,
                                 const ProbeTap* tap) {
    if (!tap || !batch.live.any()) return depth_test(pipe, sample, batch);
    return told_depth_test(pipe, sample, batch, *tap);
}

void run_color_write(const FragmentPipe& pipe,
                     unsigned sample,
                     const FragmentBatch& batch,
                     const ProbeTap* tap) {
    if (!batch.live.any()) return;
    for (unsigned i = 0; i < ColorTargets; ++i) {
        const ColorTarget& target = pipe.color_targets[i];
        if (target.write_mask == 0) continue;
        if (!tap) {
            pipe.stages->write_color(pipe.color_stage,
                                     {target.surface.plane(sample), target.write_mask, target.srgb},
                                     batch,
                                     pipe.memory);
            continue;
        }
        const auto told = std::make_unique<probed::ColorWrite>();
        told->target = i;
        told->sample = sample;
        tell_color_write(pipe, *told, batch, *tap);
    }
}

} // namespace ffgpu
