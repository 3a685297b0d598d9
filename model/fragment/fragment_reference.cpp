#include "model/fragment/fragment_reference.h"

#include "model/fragment/alpha_test.h"
#include "model/fragment/color_sum.h"
#include "model/fragment/sample_mask.h"

namespace ffgpu {
namespace {

PixelColor plane_color(const ColorPlanes& planes, unsigned lane) {
    const auto byte = [&](std::uint16_t value) { return static_cast<std::uint8_t>(value); };
    return {byte(planes.r[lane]), byte(planes.g[lane]), byte(planes.b[lane]), byte(planes.a[lane])};
}

void set_plane_color(ColorPlanes& planes, unsigned lane, const PixelColor& color) {
    planes.r[lane] = color[0];
    planes.g[lane] = color[1];
    planes.b[lane] = color[2];
    planes.a[lane] = color[3];
}

CombineInputs combine_inputs(const FragmentPipe& pipe, const FragmentBatch& batch, unsigned lane) {
    CombineInputs inputs{};
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        inputs.texture[unit] = (pipe.sampled_units >> unit & 1) != 0
                                   ? plane_color(batch.texture[unit], lane)
                                   : UnsampledTexture;
    inputs.primary = plane_color(batch.primary, lane);
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
        color = add_secondary(color, plane_color(batch.secondary, lane));
    if (pipe.fog.mode != FogMode::Off)
        color = apply_fog(pipe.fog, fog_factor(pipe.fog, batch.fog_coordinate[lane]), color);
    if (pipe.antialias) color = apply_coverage(color, batch.antialias[lane]);
    return color;
}

// --- Targets ----------------------------------------------------------------------------------

struct Position {
    std::uint32_t x, y;
};

Position position(const FragmentBatch& batch, unsigned lane) {
    return {batch.x[lane / 4] + (lane & 1), batch.y[lane / 4] + (lane >> 1 & 1)};
}

bool front_facing(const FragmentBatch& batch, unsigned lane) {
    const unsigned quad = lane / 4;
    return (batch.front_facing[quad / 64] >> (quad % 64) & 1) != 0;
}

StencilDepthPixel load_stencil_depth(Format format, const std::byte* at) {
    if (format == Format::Depth16) return {load_word<std::uint16_t>(at), 0};
    const auto word = load_word<std::uint32_t>(at);
    return {word >> 8, static_cast<std::uint8_t>(word)};
}

void store_stencil_depth(Format format, StencilDepthPixel pixel, std::byte* at) {
    if (format == Format::Depth16) return store_word(at, static_cast<std::uint16_t>(pixel.depth));
    store_word(at, pixel.depth << 8 | pixel.stencil);
}

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
    const auto [x, y] = position(batch, sample.lane);
    std::byte* at = pixel_address(pipe.depth_target.plane(sample.index), pipe.memory, x, y);
    const Format format = pipe.depth_target.format;
    const StencilDepthPixel stored = load_stencil_depth(format, at);
    const StencilDepthResult result = test_stencil_depth(
        pipe.stencil_depth, front_facing(batch, sample.lane), depth(batch, pipe, sample), stored);
    if (result.pixel != stored) store_stencil_depth(format, result.pixel, at);
    return result;
}

// The colour in the precision of the target: as it reads once it is stored.
PixelColor to_target(const FragmentPipe& pipe, Format format, Position at, PixelColor color) {
    const std::uint32_t word = pack_rgba8(color);
    const bool dithers = pipe.color_stage.dither && is_narrow(format);
    const Dithered dithered{bayer_threshold(at.x, at.y)};
    const std::uint32_t pixel =
        dithers ? pack_pixel(format, word, dithered) : pack_pixel(format, word);
    return unpack_rgba8(unpack_pixel(format, pixel));
}

void write_color(const FragmentPipe& pipe,
                 const ColorTarget& target,
                 Position at,
                 PixelColor source) {
    const Registers& registers = *pipe.registers;
    const Format format = target.surface.format;
    std::byte* address = pixel_address(target.surface, pipe.memory, at.x, at.y);
    const PixelColor stored = unpack_rgba8(load_rgba8(format, address));

    PixelColor color = source;
    if (pipe.color_stage.operation == ColorOperation::Blend)
        color = blend(registers.blend, source, stored);
    color = to_target(pipe, format, at, color);
    if (pipe.color_stage.operation == ColorOperation::Logic)
        color = unpack_rgba8(
            apply_logic_op(registers.blend.logic_op, pack_rgba8(color), pack_rgba8(stored)));
    for (unsigned channel = 0; channel < 4; ++channel)
        if ((target.write_mask >> channel & 1) == 0) color[channel] = stored[channel];
    store_rgba8(format, pack_rgba8(color), address);
}

// The samples, a bit each, that the multisample operations leave of a fragment; alpha may become 1.
unsigned sample_coverage(const Multisample& state, Position at, PixelColor& color) {
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
            write_color(pipe,
                        {target.surface.plane(sample.index), target.write_mask},
                        position(batch, sample.lane),
                        color);
    return true;
}

} // namespace

void early_depth_test_reference(const FragmentPipe& pipe, FragmentBatch& batch) {
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

void shade_reference(const FragmentPipe& pipe, FragmentBatch& batch) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        set_plane_color(batch.color, lane, shade_fragment(pipe, batch, lane));
}

void write_reference(const FragmentPipe& pipe, FragmentBatch& batch, FragmentFates& fates) {
    const FragmentControl& control = pipe.registers->fragment;
    fates = {};
    SampleMasks passed;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        PixelColor color = plane_color(batch.color, lane);
        unsigned samples = 0;
        for (unsigned i = 0; i < pipe.samples; ++i)
            samples |= unsigned{is_covered(batch, pipe, {lane, i})} << i;
        if (pipe.samples > 1)
            samples &= sample_coverage(pipe.registers->multisample, position(batch, lane), color);
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

} // namespace ffgpu
