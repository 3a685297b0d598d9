// Lowers the state of points, lines and polygons.

#pragma once

#include "driver/state/rasterization_state.h"
#include "driver/state/texture_state.h"
#include "model/device/registers/primitive.h"

namespace ffgpu::gl {

PrimitiveSetup
lower_primitive(const RasterizationState& gl, const TextureState& texture, GLenum shade_model);
PolygonStipple lower_polygon_stipple(const RasterizationState& gl);

} // namespace ffgpu::gl
