#include "driver/lower/lighting.h"

#include "driver/lower/color_material.h"
#include "driver/math/sin_cos.h"

#include <cmath>

namespace ffgpu::gl {
namespace {

// A direction without length stays (0, 0, 0): no vertex lies inside such a spot unless its cut-off
// angle is 90 degrees.
std::array<float, 3> normalized(const std::array<float, 3>& v) {
    const double x = static_cast<double>(v[0]);
    const double y = static_cast<double>(v[1]);
    const double z = static_cast<double>(v[2]);
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
    return {static_cast<float>(x / length),
            static_cast<float>(y / length),
            static_cast<float>(z / length)};
}

} // namespace

Lighting lower_lighting(const LightingState& gl) {
    return {.enable = gl.enable,
            .two_sided = gl.model.two_side,
            .local_viewer = gl.model.local_viewer,
            .separate_specular = gl.model.color_control == GL_SEPARATE_SPECULAR_COLOR,
            .color_material_front = tracked_colors(gl.color_material, 0),
            .color_material_back = tracked_colors(gl.color_material, 1),
            .scene_ambient = gl.model.ambient};
}

Light lower_light(const LightSource& gl) {
    if (!gl.enable) return {}; // One value, so that changes of a light that is off cost nothing.
    const bool is_spot = gl.spot_cutoff != 180;
    return {.enable = true,
            .ambient = gl.ambient,
            .diffuse = gl.diffuse,
            .specular = gl.specular,
            .position = gl.position,
            .spot_direction = normalized(gl.spot_direction),
            .spot_exponent = gl.spot_exponent,
            .spot_cutoff_cosine =
                is_spot
                    ? static_cast<float>(sin_cos_degrees(static_cast<double>(gl.spot_cutoff)).cos)
                    : -1,
            .attenuation = gl.attenuation};
}

Material lower_material(const MaterialFace& gl) {
    return {.ambient = gl.ambient,
            .diffuse = gl.diffuse,
            .specular = gl.specular,
            .emission = gl.emission,
            .shininess = gl.shininess};
}

} // namespace ffgpu::gl
