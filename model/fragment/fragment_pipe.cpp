#include "model/fragment/fragment_pipe.h"

#include "model/fragment/fragment_reference.h"

namespace ffgpu {
namespace {

// A target that no fragment within the scissor can leave.
bool usable(const Surface& surface, const Scissor& scissor, std::uint64_t memory_size) {
    return surface_fits(surface, memory_size) && scissor.x >= 0 && scissor.y >= 0 &&
           scissor.x + scissor.width <= surface.width &&
           scissor.y + scissor.height <= surface.height;
}

bool is_color_target(Format format) {
    return format == Format::Rgba8 || format == Format::Rgbx8 || format == Format::Rgb565;
}

ColorTarget compile_color_target(const Surface& surface, std::uint8_t write_mask) {
    const bool has_alpha = surface.format == Format::Rgba8;
    return {surface, static_cast<std::uint8_t>(write_mask & (has_alpha ? 0xf : 0x7))};
}

} // namespace

FragmentPipe compile_fragment_pipe(const DrawState& state, std::span<std::byte> memory) {
    const Registers& registers = state.regs();
    FragmentPipe pipe;
    pipe.registers = state.registers;
    pipe.memory = memory;
    pipe.sampled_units = state.units;
    pipe.antialias = state.antialias;
    pipe.fog = compile_fog(registers.fog);

    const Surface& depth = registers.targets.depth;
    if (is_depth_target(depth.format) && usable(depth, registers.scissor, memory.size()))
        pipe.depth_target = depth;
    pipe.stencil_depth =
        compile_stencil_depth(registers.stencil, registers.depth, pipe.depth_target.format);
    pipe.early_depth = state.early_depth && !pipe.stencil_depth.stencil;

    pipe.color_operation = color_operation(registers.blend);
    const Surface* colors[] = {&registers.targets.color, &registers.targets.second_color};
    for (unsigned i = 0; i < pipe.color_targets.size(); ++i)
        if (is_color_target(colors[i]->format) &&
            usable(*colors[i], registers.scissor, memory.size()))
            pipe.color_targets[i] = compile_color_target(*colors[i], registers.blend.write_mask);
    return pipe;
}

void early_depth_test(const FragmentPipe& pipe, FragmentBatch& batch) {
    early_depth_test_reference(pipe, batch);
}

void shade(const FragmentPipe& pipe, FragmentBatch& batch) {
    shade_reference(pipe, batch);
}

void write(const FragmentPipe& pipe, FragmentBatch& batch, FragmentFates& fates) {
    write_reference(pipe, batch, fates);
}

} // namespace ffgpu
