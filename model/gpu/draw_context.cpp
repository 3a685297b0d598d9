#include "model/gpu/draw_context.h"

#include <algorithm>
#include <utility>

namespace ffgpu {
namespace {

std::shared_ptr<const PixelContext> compile_pixel_context(const DrawState& state,
                                                          const PixelBackend& backend) {
    const Registers& r = state.regs();
    auto pixels = std::make_shared<PixelContext>();
    pixels->layout = state.layout;
    pixels->units = state.units;
    pixels->needs_depth = state.needs_depth;
    pixels->antialias = state.antialias;
    pixels->multisample = state.multisample;
    pixels->count_samples = r.fragment.count_samples;
    pixels->stipple = stipple_patterns(r.polygon_stipple, r.primitive);
    pixels->pipe = compile_fragment_pipe(state, backend.memory, backend.stages);
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        if (pixels->samples(unit))
            pixels->textures[unit] =
                compile_texture_unit(r.images[unit], r.samplers[unit], backend.memory);
    return pixels;
}

} // namespace

std::shared_ptr<const DrawContext> compile_draw_context(std::shared_ptr<const Registers> registers,
                                                        std::uint32_t number,
                                                        const PixelBackend& backend,
                                                        const DrawContext* earlier) {
    auto context = std::make_shared<DrawContext>();
    context->state = compile_draw_state(std::move(registers), number);
    context->setup = compile_setup(context->state);
    // Which coordinates are carried depends on the vertices' format, matrices and generation.
    context->pixels = earlier && earlier->pixels->layout == context->state.layout
                          ? earlier->pixels
                          : compile_pixel_context(context->state, backend);
    return context;
}

} // namespace ffgpu
