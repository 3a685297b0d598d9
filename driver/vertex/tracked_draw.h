// Runs whose vertices differ in one colour of their materials, as from glMaterial with
// GL_AMBIENT_AND_DIFFUSE at each vertex: the device lights them by itself, with that colour as the
// vertices' own and materials that track it (GL 1.5, 2.14.3).

#pragma once

#include "driver/vertex/material_log.h"
#include "driver/vertex/vertex_run.h"

namespace ffgpu::gl {

class VertexContext;

// `changes` begins at vertex 0. False, with nothing drawn: the vertices differ in more than that,
// or their materials track the current colour already.
bool draw_tracked(VertexContext& context,
                  const VertexRun& run,
                  std::span<const MaterialChange> changes);

} // namespace ffgpu::gl
