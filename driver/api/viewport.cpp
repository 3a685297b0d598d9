// Controlling the viewport (GL 1.5, 2.11.1).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/math/conversion.h"

#include <algorithm>

namespace ffgpu::gl::api {

void Viewport(Context& context, GLint x, GLint y, GLsizei width, GLsizei height) {
    if (width < 0 || height < 0) return context.error(GL_INVALID_VALUE);
    // Larger sizes are cut silently to GL_MAX_VIEWPORT_DIMS.
    constexpr auto Max = static_cast<GLsizei>(MaxSurfaceSize);
    ViewportState& viewport = context.state.transform.viewport;
    viewport.x = x;
    viewport.y = y;
    viewport.width = std::min(width, Max);
    viewport.height = std::min(height, Max);
    context.dirty.mark(Dirty::Viewport);
}

void DepthRange(Context& context, GLdouble near, GLdouble far) {
    ViewportState& viewport = context.state.transform.viewport;
    viewport.near_depth = clamp_unit(near);
    viewport.far_depth = clamp_unit(far);
    context.dirty.mark(Dirty::Viewport);
}

} // namespace ffgpu::gl::api
