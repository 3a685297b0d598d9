// Draws a run whose vertices have materials of their own: glMaterial came between glBegin and
// glEnd. The device has one material a face and draw, but a material colour may follow the vertex's
// colour. So
//
//   - where the materials differ in colours that have one value a vertex, and the application's
//     colours are not in use, that value becomes the vertices' colour; where it has one a face,
//     each polygon's vertices take that of the face that shows;
//   - else a primitive whose vertices have the same materials is drawn with these;
//   - else the vertices are lit here, and drawn without lighting.

#pragma once

#include "driver/vertex/material_log.h"
#include "driver/vertex/vertex_run.h"

namespace ffgpu::gl {

class VertexContext;

// `changes` begins at vertex 0. The context's materials are the latest.
void draw_with_materials(VertexContext& context,
                         const VertexRun& run,
                         std::span<const MaterialChange> changes);

} // namespace ffgpu::gl
