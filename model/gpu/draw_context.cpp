#include "model/gpu/draw_context.h"

#include <algorithm>

namespace ffgpu {

std::shared_ptr<const DrawContext> compile_draw_context(std::shared_ptr<const Registers> registers,
                                                        std::uint32_t number,
                                                        std::span<std::byte> memory) {
    const Registers& r = *registers;
    auto context = std::make_shared<DrawContext>();
    context->state = compile_draw_state(registers, number);
    context->setup = compile_setup(context->state);
    context->stipple = {r.polygon_stipple.rows,
                        r.primitive.line_stipple_pattern,
                        std::max<std::uint16_t>(1, r.primitive.line_stipple_factor)};
    context->pipe = compile_fragment_pipe(context->state, memory);
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        if (context->samples(unit))
            context->textures[unit] =
                compile_texture_unit(r.images[unit], r.samplers[unit], memory);
    return context;
}

} // namespace ffgpu
