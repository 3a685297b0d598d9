// Draws polygons whose vertices differ with the face that shows: each polygon takes its vertices
// from the front's or from the back's. Which face shows is decided here, from the vertices in
// window coordinates (GL 1.5, 2.14.1); beside the device's own decision, which is on snapped
// vertices, only slivers may differ.

#pragma once

#include "driver/vertex/vertex_run.h"

#include <vector>

namespace ffgpu::gl {

class VertexContext;

// Lines and points show the front.
constexpr bool is_polygon(PrimitiveType type) {
    return type >= PrimitiveType::Triangles;
}

// `words` are `primitive`'s vertices in `format` as the front has them, then as the back has them.
// The context's state is lowered.
void draw_by_face(VertexContext& context,
                  const VertexFormat& format,
                  const std::vector<float>& words,
                  const RunPrimitive& primitive);

} // namespace ffgpu::gl
