// Lowers fog and the per-fragment operations.

#pragma once

#include "driver/state/fragment_state.h"
#include "driver/state/framebuffer_state.h"
#include "driver/state/lighting_state.h"
#include "driver/state/rasterization_state.h"
#include "model/device/registers/fragment.h"

namespace ffgpu::gl {

// What the depth target offers. A test of what is not there always passes, and nothing is written
// (GL 1.5, 4.1.5 and 4.1.6).
struct DepthTarget {
    unsigned depth_bits = 0;
    unsigned stencil_bits = 0;
};

Fog lower_fog(const FogState& gl);
// `srgb_capable`: a bit for each colour target that may hold sRGB codes.
FragmentControl lower_fragment_control(const FragmentState& gl,
                                       const LightingState& lighting,
                                       bool query_is_active,
                                       std::uint8_t srgb_capable);
Stencil lower_stencil(const StencilState& gl, DepthTarget target);
DepthControl lower_depth(const DepthState& gl, DepthTarget target);
Multisample lower_multisample(const MultisampleState& gl);
Blend lower_blend(const BlendState& gl, const std::array<bool, 4>& color_mask);

} // namespace ffgpu::gl
