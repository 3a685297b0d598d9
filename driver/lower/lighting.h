// Lowers lighting state to the registers of the geometry stage.

#pragma once

#include "driver/state/lighting_state.h"
#include "model/device/registers/geometry.h"

namespace ffgpu::gl {

Lighting lower_lighting(const LightingState& gl);
Light lower_light(const LightSource& gl);
Material lower_material(const MaterialFace& gl);

} // namespace ffgpu::gl
