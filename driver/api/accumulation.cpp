// The accumulation buffer (GL 1.5, 4.2.4).

#include "driver/framebuffer/accumulation.h"

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/images/read_target.h"

namespace ffgpu::gl::api {
namespace {

bool is_operation(GLenum op) {
    return op == GL_ACCUM || op == GL_LOAD || op == GL_RETURN || op == GL_MULT || op == GL_ADD;
}

void give_back(Context& context, Accumulation& buffer, float factor) {
    const Targets& targets = context.draw_target().targets;
    const unsigned mask = context.registers.wanted.blend.write_mask;
    for (const Surface& target : targets.color)
        for (unsigned i = 0; i < target.samples * context.draw_target().supersampling; ++i)
            buffer.give_back(target.plane(i), factor, mask);
}

} // namespace

void Accum(Context& context, GLenum op, GLfloat value) {
    if (!is_operation(op)) return context.error(GL_INVALID_ENUM);
    Drawable* const drawable = context.draw_drawable();
    const bool has_buffer = drawable && drawable->format().accumulation &&
                            !context.state.framebuffer.draw_object &&
                            !context.state.framebuffer.read_object;
    if (!has_buffer) return context.error(GL_INVALID_OPERATION);
    if (context.render_modes().mode() != GL_RENDER || !context.prepare_draw()) return;

    Accumulation buffer(context.device(), *drawable, context.registers.wanted.scissor);
    switch (op) {
    case GL_ACCUM:
        return buffer.accumulate(find_read_target(context).pixel_colors(), value);
    case GL_LOAD:
        return buffer.load(find_read_target(context).pixel_colors(), value);
    case GL_ADD:
        return buffer.add(value);
    case GL_MULT:
        return buffer.multiply(value);
    default:
        return give_back(context, buffer, value);
    }
}

} // namespace ffgpu::gl::api
