// Whether the framebuffer that is drawn to has what pixels of a kind go into.

#pragma once

#include "driver/gl_types.h"
#include "driver/pixel/pixel_format.h"

namespace ffgpu::gl {

class DeviceContext;

// GL_NO_ERROR; GL_INVALID_FRAMEBUFFER_OPERATION: it is incomplete; GL_INVALID_OPERATION: it has no
// depth or stencil buffer for such pixels.
GLenum draw_buffers_error(DeviceContext& context, PixelKind kind);

} // namespace ffgpu::gl
