// Draws a run whose vertices have materials of their own: glMaterial came between glBegin and
// glEnd. The device has one material a face and draw. Where that does not do, and a colour that
// materials track does not either, such vertices are lit here, by the code of the raster position,
// and drawn without lighting: exact to float rounding.

#pragma once

#include "driver/vertex/material_log.h"
#include "driver/vertex/vertex_run.h"

namespace ffgpu::gl {

class VertexContext;

// `changes` begins at vertex 0.
void draw_lit(VertexContext& context,
              const VertexRun& run,
              std::span<const MaterialChange> changes);

} // namespace ffgpu::gl
