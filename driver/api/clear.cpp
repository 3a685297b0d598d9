// Clearing buffers (GL 1.5, 4.2.3).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/feedback/render_modes.h"
#include "driver/framebuffer/accumulation.h"
#include "driver/lower/fragment.h"
#include "driver/lower/targets.h"
#include "driver/math/conversion.h"
#include "driver/pixel/rgba8.h"

#include <algorithm>

namespace ffgpu::gl::api {
namespace {

constexpr GLbitfield AllBuffers =
    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT;

ClearCommand lower_clear(const State& state, GLbitfield mask, DepthTarget depth) {
    const DepthState& gl_depth = state.fragment.depth;
    ClearCommand clear;
    clear.color = (mask & GL_COLOR_BUFFER_BIT) != 0;
    clear.depth = (mask & GL_DEPTH_BUFFER_BIT) != 0 && gl_depth.write_mask && depth.depth_bits > 0;
    clear.stencil = (mask & GL_STENCIL_BUFFER_BIT) != 0 && depth.stencil_bits > 0;
    clear.color_value = pack_rgba8(state.framebuffer.clear_color);
    clear.depth_value = unorm(gl_depth.clear_value, depth.depth_bits);
    clear.stencil_value = static_cast<std::uint8_t>(state.fragment.stencil.clear_value);
    return clear;
}

void clear_accumulation(Context& context) {
    Drawable* const drawable = context.draw_drawable();
    if (!drawable || context.state.framebuffer.draw_object) return;
    if (!drawable->format().accumulation) return;
    Accumulation(context.device(), *drawable, context.registers.wanted.scissor)
        .clear(context.state.framebuffer.clear_accum);
}

bool is_back(GLenum buffer) {
    return buffer == GL_BACK || buffer == GL_BACK_LEFT;
}

// Whether a clear sets each colour of a window's back buffer, and draws to nothing else.
bool overwrites_back(Context& context, GLbitfield mask) {
    const Drawable* const drawable = context.draw_drawable();
    const FramebufferState& framebuffer = context.state.framebuffer;
    if (!drawable || framebuffer.draw_object || !(mask & GL_COLOR_BUFFER_BIT)) return false;
    const auto& buffers = framebuffer.draw_buffers;
    if (!is_back(buffers[0]) || framebuffer.color_mask != std::array{true, true, true, true})
        return false;
    if (std::any_of(buffers.begin() + 1, buffers.end(), [](GLenum b) { return b != GL_NONE; }))
        return false;
    const ScissorState& scissor = context.state.fragment.scissor;
    const unsigned width = drawable->width(), height = drawable->height();
    return lower_scissor(scissor, width, height) == lower_scissor({}, width, height);
}

float clamp_signed_unit(float value) {
    return value > 1 ? 1.0f : value >= -1 ? value : value < -1 ? -1.0f : 0.0f;
}

} // namespace

void Clear(Context& context, GLbitfield mask) {
    if (mask & ~AllBuffers) return context.error(GL_INVALID_VALUE);
    if (context.render_modes().mode() != GL_RENDER) return;
    if (overwrites_back(context, mask)) context.draw_drawable()->note_back_overwritten();
    if (!context.prepare_draw()) return;

    const ClearCommand clear = lower_clear(context.state, mask, context.draw_target().depth);
    if (clear.color || clear.depth || clear.stencil) {
        CommandStream commands;
        commands.add(clear);
        context.submit_drawing(commands);
    }
    if (mask & GL_ACCUM_BUFFER_BIT) clear_accumulation(context);
}

void ClearColor(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    context.state.framebuffer.clear_color = {
        clamp_unit(red), clamp_unit(green), clamp_unit(blue), clamp_unit(alpha)};
}

void ClearIndex(Context& context, GLfloat c) {
    context.state.framebuffer.clear_index = c;
}

void ClearDepth(Context& context, GLdouble depth) {
    context.state.fragment.depth.clear_value = clamp_unit(depth);
}

void ClearStencil(Context& context, GLint s) {
    context.state.fragment.stencil.clear_value = s;
}

void ClearAccum(Context& context, GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
    context.state.framebuffer.clear_accum = {clamp_signed_unit(red),
                                             clamp_signed_unit(green),
                                             clamp_signed_unit(blue),
                                             clamp_signed_unit(alpha)};
}

} // namespace ffgpu::gl::api
