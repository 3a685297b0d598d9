#include "driver/context/current.h"

#include "driver/context/context.h"
#include "driver/framebuffer/drawable.h"

namespace ffgpu::gl {

namespace detail {
constinit thread_local Context* current = nullptr;
} // namespace detail

namespace {

void set_initial_sizes(State& state, const Drawable& draw) {
    const auto width = static_cast<GLsizei>(draw.width());
    const auto height = static_cast<GLsizei>(draw.height());
    state.transform.viewport.width = state.fragment.scissor.width = width;
    state.transform.viewport.height = state.fragment.scissor.height = height;
}

void set_initial_buffers(FramebufferState& framebuffer, const Drawable& draw) {
    if (draw.format().double_buffer) return;
    framebuffer.draw_buffers = {GL_FRONT};
    framebuffer.read_buffer = GL_FRONT;
}

} // namespace

void make_current(Context* context, Drawable* draw, Drawable* read) {
    Context* const before = detail::current;
    if (before) before->flush_vertices();
    detail::current = context;
    if (!context) return;

    if (draw && !context->was_bound) {
        set_initial_sizes(context->state, *draw);
        set_initial_buffers(context->state.framebuffer, *draw);
        context->was_bound = true;
    }
    context->set_drawables(draw, read);
    context->dirty.mark(Dirty::Targets);
    context->dirty.mark(Dirty::Viewport);
    // Another context may have written the device's registers since.
    if (before != context) context->registers.forget();
}

} // namespace ffgpu::gl
