// Lowers transformation state to the registers of the geometry stage.

#pragma once

#include "driver/state/texture_state.h"
#include "driver/state/transform_state.h"
#include "model/device/registers/geometry.h"

namespace ffgpu::gl {

Transform lower_transform(const TransformState& gl);
UserClipPlanes lower_clip_planes(const TransformGroup& gl);
Viewport lower_viewport(const ViewportState& gl, bool depth_clamp);
TexCoordSetup lower_tex_coords(const TextureUnit& unit, const Mat4& texture_matrix);

} // namespace ffgpu::gl
