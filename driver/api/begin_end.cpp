// glBegin and glEnd (GL 1.5, 2.6), and the restart within them (NV_primitive_restart).

#include "driver/commands/declarations.h"
#include "driver/context/context.h"
#include "driver/vertex/vertex_assembler.h"

namespace ffgpu::gl::api {

void Begin(Context& context, GLenum mode) {
    context.vertices().begin(mode);
}

void End(Context& context) {
    context.vertices().end();
}

void PrimitiveRestartNV(Context& context) {
    context.vertices().restart();
}

void PrimitiveRestartIndexNV(Context& context, GLuint index) {
    context.client.arrays.restart_index = index;
}

} // namespace ffgpu::gl::api
