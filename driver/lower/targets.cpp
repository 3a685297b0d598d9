#include "driver/lower/targets.h"

#include "driver/framebuffer/drawable.h"

#include <algorithm>

namespace ffgpu::gl {
namespace {

// Of a token that selects buffers of a window.
bool has_front(GLenum buffer) {
    return buffer == GL_FRONT || buffer == GL_FRONT_LEFT || buffer == GL_LEFT ||
           buffer == GL_FRONT_AND_BACK;
}

bool has_back(GLenum buffer) {
    return buffer == GL_BACK || buffer == GL_BACK_LEFT || buffer == GL_LEFT ||
           buffer == GL_FRONT_AND_BACK;
}

} // namespace

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
