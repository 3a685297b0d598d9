// Lowers which of a window's buffers are drawn to, and the scissor.

#pragma once

#include "driver/state/fragment_state.h"
#include "driver/state/framebuffer_state.h"
#include "model/device/registers/fragment.h"
#include "model/device/registers/primitive.h"

namespace ffgpu::gl {

class Drawable;

Targets lower_window_targets(const Drawable& drawable, const DrawBufferList& buffers);
Scissor lower_scissor(const ScissorState& gl, unsigned width, unsigned height);

} // namespace ffgpu::gl
