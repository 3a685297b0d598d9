#include "model/fragment/fragment_pipe.h"

#include "model/fragment/fragment_tap.h"
#include "model/fragment/sample_pipe.h"

#include <cstddef>
#include <cstring>

namespace ffgpu {
namespace {

ColorTarget compile_color_target(const Registers& registers, unsigned i) {
    const Surface& surface = registers.targets.color[i];
    const unsigned channels = registers.blend.write_mask & stored_channels(surface.format);
    return {surface, static_cast<std::uint8_t>(channels), registers.fragment.is_srgb(i)};
}

bool keeps_colors(const FragmentPipe& pipe) {
    const FragmentControl& control = pipe.registers->fragment;
    bool keeps = pipe.samples == 1 && !pipe.antialias && pipe.environments.units.empty() &&
                 !control.color_sum && pipe.fog.mode == FogMode::Off && !control.alpha_test &&
                 pipe.color_stage.operation == ColorOperation::Replace;
    for (const ColorTarget& target : pipe.color_targets)
        keeps &= target.write_mask == 0 ||
                 (target.surface.format == Format::Rgba8 &&
                  target.write_mask == stored_channels(Format::Rgba8) && !target.srgb);
    return keeps;
}

// Without environments the primary colour goes on.
void take_primary(FragmentBatch& batch) {
    const std::size_t bytes = batch.lanes() * sizeof(std::uint16_t);
    const ColorPlanes& from = batch.primary;
    ColorPlanes& to = batch.color;
    std::memcpy(to.r.data(), from.r.data(), bytes);
    std::memcpy(to.g.data(), from.g.data(), bytes);
    std::memcpy(to.b.data(), from.b.data(), bytes);
    std::memcpy(to.a.data(), from.a.data(), bytes);
}

// Behind the alpha test.
void late_depth_test(const FragmentPipe& pipe,
                     FragmentBatch& batch,
                     FragmentFates& fates,
                     const ProbeTap* tap) {
    fates.after_alpha = fates.after_stencil = fates.after_depth = batch.live;
    if (pipe.early_depth) return;
    const StencilDepthFates tested = run_depth_test(pipe, 0, batch, tap);
    fates.after_stencil = tested.after_stencil;
    fates.after_depth = tested.after_depth;
    batch.live = fates.after_depth;
}

} // namespace

FragmentPipe compile_fragment_pipe(const DrawState& state,
                                   std::span<std::byte> memory,
                                   const FragmentStages& stages) {
    const Registers& registers = state.regs();
    FragmentPipe pipe;
    pipe.stages = &stages;
    pipe.registers = state.registers;
    pipe.memory = memory;
    pipe.samples = state.samples;
    pipe.antialias = state.antialias;
    pipe.environments = compile_environments(registers.combiners, state.units);
    pipe.fog = compile_fog(registers.fog);

    const Surface& depth = registers.targets.depth;
    if (is_depth_target(depth.format) && surface_fits(depth, memory.size()))
        pipe.depth_target = depth;
    pipe.stencil_depth =
        compile_stencil_depth(registers.stencil, registers.depth, pipe.depth_target.format);
    pipe.early_depth = state.early_depth && !pipe.stencil_depth.stencil;

    pipe.color_stage = compile_color_stage(registers.blend, registers.fragment.dither);
    for (unsigned i = 0; i < ColorTargets; ++i) {
        const Surface& color = registers.targets.color[i];
        if (is_plain_color(color.format) && surface_fits(color, memory.size()))
            pipe.color_targets[i] = compile_color_target(registers, i);
    }
    pipe.keeps_colors = keeps_colors(pipe);
    return pipe;
}

void early_depth_test(const FragmentPipe& pipe, FragmentBatch& batch, const ProbeTap* tap) {
    if (pipe.samples > 1) return early_depth_test_samples(pipe, batch, tap);
    if (pipe.early_depth) batch.live = run_depth_test(pipe, 0, batch, tap).after_depth;
}

void shade(const FragmentPipe& pipe, FragmentBatch& batch, const ProbeTap* tap) {
    const FragmentStages& stages = *pipe.stages;
    ShadeTap told(tap);
    if (pipe.environments.units.empty()) take_primary(batch);
    for (unsigned i = 0; i < pipe.environments.units.size(); ++i) {
        told.enters(i == 0 ? batch.primary : batch.color);
        stages.run_environment(pipe.environments, i, batch);
        told.environment(pipe.environments.units[i].unit);
    }
    if (pipe.registers->fragment.color_sum) {
        told.enters(batch.color);
        stages.add_secondary(batch);
        told.color_sum();
    }
    if (pipe.fog.mode != FogMode::Off) {
        told.enters(batch.color);
        stages.apply_fog(pipe.fog, batch);
        told.fog(pipe.fog);
    }
    if (pipe.antialias) {
        told.enters(batch.color);
        stages.apply_coverage(batch);
        told.antialias();
    }
}

void write(const FragmentPipe& pipe,
           FragmentBatch& batch,
           FragmentFates& fates,
           const ProbeTap* tap) {
    if (pipe.samples > 1) return write_samples(pipe, batch, fates, tap);
    fates.after_coverage = batch.live;
    batch.live = run_alpha_test(pipe, batch, tap);
    late_depth_test(pipe, batch, fates, tap);
    if (pipe.stores_colors) run_color_write(pipe, 0, batch, tap);
}

void write_kept(const FragmentPipe& pipe,
                const LaneWords& colors,
                FragmentBatch& batch,
                FragmentFates& fates) {
    fates.after_coverage = batch.live;
    late_depth_test(pipe, batch, fates, nullptr);
    if (!batch.live.any()) return;
    for (const ColorTarget& target : pipe.color_targets)
        if (target.write_mask != 0)
            store_quads(target.surface, pipe.memory, batch, batch.live, colors);
}

} // namespace ffgpu
