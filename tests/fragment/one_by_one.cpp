#include "tests/fragment/one_by_one.h"

#include "model/fragment/alpha_test.h"
#include "model/fragment/color_sum.h"
#include "model/fragment/depth_target.h"
#include "model/fragment/lane_access.h"
#include "model/fragment/sample_mask.h"

namespace ffgpu::test {
namespace {

CombineInputs combine_inputs(const FragmentPipe& pipe, const FragmentBatch& batch, unsigned lane) {
    CombineInputs inputs{};
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        inputs.texture[unit] = (pipe.environments.sampled_units >> unit & 1) != 0
                                   ? lane_color(batch.texture[unit], lane)
                                   : UnsampledTexture;
    inputs.primary = lane_color(batch.primary, lane);
    inputs.previous = inputs.primary;
    return inputs;
}

PixelColor shade_fragment(const FragmentPipe& pipe, const FragmentBatch& batch, unsigned lane) {
    const Registers& registers = *pipe.registers;
    CombineInputs inputs = combine_inputs(pipe, batch, lane);
    for (const Combiner& combiner : registers.combiners)
        if (combiner.enable) inputs.previous = combine(combiner, inputs);

    PixelColor color = inputs.previous;
    if (registers.fragment.color_sum)
        color = add_secondary(color, lane_color(batch.secondary, lane));
    if (pipe.fog.mode != FogMode::Off)
        color = apply_fog(pipe.fog, fog_factor(pipe.fog, batch.fog_coordinate[lane]), color);
    if (pipe.antialias) color = apply_coverage(color, batch.antialias[lane]);
    return color;
}

// --- Targets ----------------------------------------------------------------------------------

// One of a fragment's samples; single-sampled targets have sample 0 alone.
struct Sample {
    unsigned lane, index;
};

bool is_covered(const FragmentBatch& batch, const FragmentPipe& pipe, Sample sample) {
    return (pipe.samples > 1 ? batch.samples[sample.index] : batch.live).test(sample.lane);
}

std::uint32_t depth(const FragmentBatch& batch, const FragmentPipe& pipe, Sample sample) {
    return pipe.samples > 1 && batch.sample_depths
               ? batch.sample_depths->of[sample.index][sample.lane]
               : batch.depth[sample.lane];
}

StencilDepthResult
visit_depth_target(const FragmentPipe& pipe, const FragmentBatch& batch, Sample sample) {
    if (!pipe.stencil_depth.active()) return {true, true, {}};
    const auto [x, y] = lane_position(batch, sample.lane);
    std::byte* at = pixel_address(pipe.depth_target.plane(sample.index), pipe.memory, x, y);
    const Format format = pipe.depth_target.format;
    const StencilDepthPixel stored = load_stencil_depth(format, at);
    const StencilDepthResult result = test_stencil_depth(pipe.stencil_depth,
                                                         lane_front_facing(batch, sample.lane),
                                                         depth(batch, pipe, sample),
                                                         stored);
    if (result.pixel != stored) store_stencil_depth(format, result.pixel, at);
    return result;
}

void write_pixel(const FragmentPipe& pipe,
                 const ColorTarget& target,
                 LanePosition at,
                 const PixelColor& color) {
    std::byte* const address = pixel_address(target.surface, pipe.memory, at.x, at.y);
    const Format format = target.surface.format;
    const PixelColor stored = unpack_rgba8(load_rgba8(format, address));
    store_rgba8(format,
                pack_rgba8(written_color(pipe.color_stage, target, {at.x, at.y, color}, stored)),
                address);
}

// The samples, a bit each, that the multisample operations leave of a fragment; alpha may become 1.
unsigned sample_coverage(const Multisample& state, LanePosition at, PixelColor& color) {
    unsigned samples = (1u << MaxSamples) - 1;
    if (!state.enable) return samples;
    if (state.alpha_to_coverage) samples &= alpha_coverage(color[3], at.x, at.y);
    if (state.alpha_to_one) color[3] = 255;
    return samples & state.sample_mask;
}

// The way of one sample through the stencil and depth test and the blend; true: to its end.
bool write_sample(const FragmentPipe& pipe,
                  const FragmentBatch& batch,
                  Sample sample,
                  const PixelColor& color,
                  FragmentFates& fates) {
    StencilDepthResult result{true, true, {}};
    if (!pipe.early_depth) result = visit_depth_target(pipe, batch, sample);
    if (result.passes_stencil) fates.after_stencil.set(sample.lane);
    if (!result.passes_depth) return false;
    fates.after_depth.set(sample.lane);
    for (const ColorTarget& target : pipe.color_targets)
        if (target.write_mask != 0)
            write_pixel(pipe,
                        {target.surface.plane(sample.index), target.write_mask},
                        lane_position(batch, sample.lane),
                        color);
    return true;
}

} // namespace

void early_depth_test_one_by_one(const FragmentPipe& pipe, FragmentBatch& batch) {
    if (!pipe.early_depth) return;
    SampleMasks passed;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        for (unsigned i = 0; i < pipe.samples; ++i)
            if (is_covered(batch, pipe, {lane, i}) &&
                visit_depth_target(pipe, batch, {lane, i}).passes_depth)
                passed[i].set(lane);
    if (pipe.samples > 1) batch.samples = passed;
    batch.live = any_sample(passed);
}

void shade_one_by_one(const FragmentPipe& pipe, FragmentBatch& batch) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        set_lane_color(batch.color, lane, shade_fragment(pipe, batch, lane));
}

void write_one_by_one(const FragmentPipe& pipe, FragmentBatch& batch, FragmentFates& fates) {
    const FragmentControl& control = pipe.registers->fragment;
    fates = {};
    SampleMasks passed;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        PixelColor color = lane_color(batch.color, lane);
        unsigned samples = 0;
        for (unsigned i = 0; i < pipe.samples; ++i)
            samples |= unsigned{is_covered(batch, pipe, {lane, i})} << i;
        if (pipe.samples > 1)
            samples &=
                sample_coverage(pipe.registers->multisample, lane_position(batch, lane), color);
        if (samples == 0) continue;
        fates.after_coverage.set(lane);
        if (!passes_alpha_test(control, color[3])) continue;
        fates.after_alpha.set(lane);
        for (unsigned i = 0; i < pipe.samples; ++i)
            if ((samples >> i & 1) != 0 && write_sample(pipe, batch, {lane, i}, color, fates))
                passed[i].set(lane);
    }
    if (pipe.samples > 1) batch.samples = passed;
    batch.live = fates.after_depth;
}

} // namespace ffgpu::test
