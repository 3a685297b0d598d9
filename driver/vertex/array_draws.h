// Draws from vertex arrays (GL 1.5, 2.8): the vertices in use are gathered and go the one draw
// path; in a display list that is being compiled, and where they are too many at once, they are
// taken apart into glBegin ... glEnd.

#pragma once

#include "driver/gl_types.h"

#include <cstdint>

namespace ffgpu::gl {

class VertexContext;

// All three report their errors. `indices` is an offset where an element buffer is bound.
void draw_arrays(VertexContext& context, GLenum mode, GLint first, GLsizei count);
void draw_elements(VertexContext& context,
                   GLenum mode,
                   GLsizei count,
                   GLenum type,
                   const void* indices,
                   GLint base_vertex = 0);
void array_element(VertexContext& context, GLint i);

} // namespace ffgpu::gl
