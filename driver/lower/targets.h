// Lowers what is drawn to: a window's buffers or a framebuffer object's, and the scissor.

#pragma once

#include "driver/gl_types.h"
#include "driver/lower/fragment.h"
#include "driver/state/fragment_state.h"
#include "driver/state/framebuffer_state.h"
#include "model/device/registers/fragment.h"
#include "model/device/registers/primitive.h"

namespace ffgpu::gl {

class Context;
class Drawable;

// The draw target as the context has it now.
struct DrawTarget {
    GLenum status = GL_FRAMEBUFFER_COMPLETE; // or why nothing can be drawn
    Targets targets{};
    unsigned width = 0, height = 0;          // of the part that all of its surfaces have
    DepthTarget depth{};                     // what of the depth surface is GL's
    Drawable* multisampled_window = nullptr; // to be told of drawing; or null
};

DrawTarget find_draw_target(Context& context);

Targets lower_window_targets(const Drawable& drawable, const DrawBufferList& buffers);
Scissor lower_scissor(const ScissorState& gl, unsigned width, unsigned height);

} // namespace ffgpu::gl
