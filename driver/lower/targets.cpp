#include "driver/lower/targets.h"

#include "driver/context/context.h"
#include "driver/framebuffer/drawable.h"
#include "driver/objects/framebuffer_object.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

unsigned depth_bits(Format format) {
    switch (format) {
    case Format::Depth24Stencil8:
        return 24;
    case Format::Depth16:
        return 16;
    default:
        return 0;
    }
}

// Of a token that selects buffers of a window.
bool has_front(GLenum buffer) {
    return buffer == GL_FRONT || buffer == GL_FRONT_LEFT || buffer == GL_LEFT ||
           buffer == GL_FRONT_AND_BACK;
}

bool has_back(GLenum buffer) {
    return buffer == GL_BACK || buffer == GL_BACK_LEFT || buffer == GL_LEFT ||
           buffer == GL_FRONT_AND_BACK;
}

DrawTarget window_target(Context& context) {
    Drawable* const drawable = context.draw_drawable();
    if (!drawable) return {.status = GL_FRAMEBUFFER_UNDEFINED};
    const PixelFormat& format = drawable->format();
    const Targets targets = lower_window_targets(*drawable, context.state.framebuffer.draw_buffers);
    return {.targets = targets,
            .width = drawable->width(),
            .height = drawable->height(),
            .depth = {.depth_bits = format.depth_bits == 0 ? 0 : depth_bits(targets.depth.format),
                      .stencil_bits = format.stencil_bits},
            .multisampled_window = format.samples > 1 ? drawable : nullptr};
}

DrawTarget object_target(Context& context, const FramebufferObject& object) {
    DrawTarget found{.status = framebuffer_status(object)};
    if (found.status != GL_FRAMEBUFFER_COMPLETE) return found;
    found.targets = framebuffer_targets(context, object);
    found.width = found.height = MaxSurfaceSize;
    Targets::for_each(found.targets, [&found](const Surface& surface) {
        if (surface.format == Format::None) return;
        found.width = std::min<unsigned>(found.width, surface.width);
        found.height = std::min<unsigned>(found.height, surface.height);
    });
    found.depth.depth_bits = has_depth(object) ? depth_bits(found.targets.depth.format) : 0;
    found.depth.stencil_bits = has_stencil(object) ? 8 : 0;
    return found;
}

} // namespace

DrawTarget find_draw_target(Context& context) {
    const auto& object = context.state.framebuffer.draw_object;
    return object ? object_target(context, *object) : window_target(context);
}

Targets lower_window_targets(const Drawable& drawable, const DrawBufferList& buffers) {
    const bool front = std::any_of(buffers.begin(), buffers.end(), has_front);
    const bool back = std::any_of(buffers.begin(), buffers.end(), has_back);
    Targets registers;
    registers.depth = drawable.depth();
    unsigned count = 0;
    if (back) registers.color[count++] = drawable.back();
    // A drawable of one buffer is drawn to once, whatever it is called.
    if (front && (!back || drawable.format().double_buffer))
        registers.color[count] = drawable.front();
    return registers;
}

Scissor lower_scissor(const ScissorState& gl, unsigned width, unsigned height) {
    // In 64 bits: the application's corner may lie anywhere.
    std::int64_t left = 0, bottom = 0, right = width, top = height;
    if (gl.enable) {
        left = std::clamp<std::int64_t>(gl.x, 0, right);
        bottom = std::clamp<std::int64_t>(gl.y, 0, top);
        right = std::clamp<std::int64_t>(std::int64_t{gl.x} + gl.width, left, right);
        top = std::clamp<std::int64_t>(std::int64_t{gl.y} + gl.height, bottom, top);
    }
    return {.x = static_cast<std::int16_t>(left),
            .y = static_cast<std::int16_t>(bottom),
            .width = static_cast<std::uint16_t>(right - left),
            .height = static_cast<std::uint16_t>(top - bottom)};
}

} // namespace ffgpu::gl
