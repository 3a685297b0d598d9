// Materials that follow the current colour (GL 1.5, 2.14.3).

#pragma once

#include "driver/state/lighting_state.h"

#include <cstdint>

namespace ffgpu::gl {

// The material colours that `color_material` tracks on a face (0 front, 1 back), as
// ColorMaterialBits; 0 while it is disabled.
std::uint8_t tracked_colors(const ColorMaterialState& color_material, unsigned face);

// The tracked colours take the value of the current colour. The device does it vertex by vertex by
// itself; the materials that GL keeps are brought up to date before they are read, saved or cease
// to be tracked.
void track_color(LightingState& lighting, const Vec4& current_color);

} // namespace ffgpu::gl
