// Draws a primitive that is lit here and not by the device, because its vertices have materials
// that the device cannot give them in one draw. Slow, and exact to float rounding.

#pragma once

#include "driver/vertex/material_log.h"
#include "driver/vertex/vertex_run.h"

namespace ffgpu::gl {

class VertexContext;

// One primitive, or several of an independent type, from vertex 0 on; `materials` are the
// vertices'.
void draw_lit(VertexContext& context,
              const VertexRun& run,
              std::span<const Materials* const> materials);

} // namespace ffgpu::gl
