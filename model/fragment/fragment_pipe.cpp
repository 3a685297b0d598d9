#include "model/fragment/fragment_pipe.h"

#include "model/fragment/alpha_test.h"
#include "model/fragment/color_sum.h"
#include "model/fragment/depth_target.h"
#include "model/fragment/sample_pipe.h"

namespace ffgpu {
namespace {

ColorTarget compile_color_target(const Surface& surface, std::uint8_t write_mask) {
    return {surface, static_cast<std::uint8_t>(write_mask & stored_channels(surface.format))};
}

StencilDepthFates visit_depth_target(const FragmentPipe& pipe, const FragmentBatch& batch) {
    return test_depth_target(pipe.stencil_depth, pipe.depth_target, batch, pipe.memory);
}

} // namespace

FragmentPipe compile_fragment_pipe(const DrawState& state, std::span<std::byte> memory) {
    const Registers& registers = state.regs();
    FragmentPipe pipe;
    pipe.registers = state.registers;
    pipe.memory = memory;
    pipe.sampled_units = state.units;
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
            pipe.color_targets[i] = compile_color_target(color, registers.blend.write_mask);
    }
    return pipe;
}

void early_depth_test(const FragmentPipe& pipe, FragmentBatch& batch) {
    if (pipe.samples > 1) return early_depth_test_samples(pipe, batch);
    if (pipe.early_depth) batch.live = visit_depth_target(pipe, batch).after_depth;
}

void shade(const FragmentPipe& pipe, FragmentBatch& batch) {
    run_environments(pipe.environments, batch);
    if (pipe.registers->fragment.color_sum) add_secondary(batch);
    if (pipe.fog.mode != FogMode::Off) apply_fog(pipe.fog, batch);
    if (pipe.antialias) apply_coverage(batch);
}

void write(const FragmentPipe& pipe, FragmentBatch& batch, FragmentFates& fates) {
    if (pipe.samples > 1) return write_samples(pipe, batch, fates);
    fates.after_coverage = batch.live;
    batch.live = alpha_test(pipe.registers->fragment, batch);
    fates.after_alpha = fates.after_stencil = fates.after_depth = batch.live;
    if (!pipe.early_depth) {
        const StencilDepthFates tested = visit_depth_target(pipe, batch);
        fates.after_stencil = tested.after_stencil;
        fates.after_depth = tested.after_depth;
    }
    batch.live = fates.after_depth;
    if (!batch.live.any()) return;
    for (const ColorTarget& target : pipe.color_targets)
        write_color(pipe.color_stage, target, batch, pipe.memory);
}

} // namespace ffgpu
