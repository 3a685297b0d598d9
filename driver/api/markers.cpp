// Markers for debuggers (GREMEDY_string_marker): they change nothing.

#include "driver/commands/declarations.h"
#include "driver/context/context.h"

namespace ffgpu::gl::api {

void StringMarkerGREMEDY(Context& context, GLsizei len, const void*) {
    if (context.fails_inside_begin()) return;
    if (len < 0) context.error(GL_INVALID_VALUE);
}

} // namespace ffgpu::gl::api
