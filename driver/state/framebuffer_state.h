// Whole-framebuffer operations (GL 1.5, 4.2 and 4.3.2; state tables 6.20 and 6.21) and the bound
// framebuffer objects.

#pragma once

#include "driver/gl_types.h"
#include "model/device/layout/limits.h"
#include "model/device/registers/geometry.h"

#include <array>
#include <memory>

namespace ffgpu::gl {

struct FramebufferObject; // driver/objects/framebuffer_object.h
struct Renderbuffer;

// What glDrawBuffers selects (ARB_draw_buffers): all that is drawn goes to each of them. What
// glDrawBuffer selects is the first.
using DrawBufferList = std::array<GLenum, ColorTargets>;

struct FramebufferState {
    // GL_COLOR_BUFFER_BIT. The draw buffers are the window's; a framebuffer object has its own. A
    // context's first drawable makes them GL_FRONT where that has no back buffer.
    DrawBufferList draw_buffers{GL_BACK};
    std::array<bool, 4> color_mask{true, true, true, true};
    GLuint index_mask = ~GLuint{0};
    Vec4 clear_color{0, 0, 0, 0};
    float clear_index = 0;

    GLenum read_buffer = GL_BACK; // GL_PIXEL_MODE_BIT; otherwise as the draw buffer

    Vec4 clear_accum{0, 0, 0, 0}; // GL_ACCUM_BUFFER_BIT

    // In no attribute group. Null: the window (framebuffer 0).
    std::shared_ptr<FramebufferObject> draw_object;
    std::shared_ptr<FramebufferObject> read_object;
    std::shared_ptr<Renderbuffer> renderbuffer;
};

} // namespace ffgpu::gl
