#include "driver/lower/transform.h"

#include "driver/math/matrix.h"

#include <cmath>

namespace ffgpu::gl {
namespace {

// GL 1.5, 2.11.3: the inverse length of the third row of the inverse of the upper left 3x3. A
// matrix of which that is not a number leaves the normals as long as they are.
float rescale_factor(const std::array<float, 9>& normal) {
    const float square = normal[2] * normal[2] + normal[5] * normal[5] + normal[8] * normal[8];
    const float factor = 1 / std::sqrt(square);
    return std::isfinite(factor) ? factor : 1;
}

NormalMode lower_normal_mode(const TransformGroup& gl) {
    if (gl.normalize) return NormalMode::Normalize; // Rescaling first would change nothing.
    return gl.rescale_normal ? NormalMode::Rescale : NormalMode::Keep;
}

TexGenMode lower_gen_mode(GLenum mode) {
    switch (mode) {
    case GL_OBJECT_LINEAR:
        return TexGenMode::ObjectLinear;
    case GL_EYE_LINEAR:
        return TexGenMode::EyeLinear;
    case GL_SPHERE_MAP:
        return TexGenMode::SphereMap;
    case GL_NORMAL_MAP:
        return TexGenMode::NormalMap;
    default:
        return TexGenMode::ReflectionMap;
    }
}

} // namespace

Transform lower_transform(const TransformState& gl) {
    Transform registers;
    registers.model_view = gl.matrices.model_view.top();
    registers.projection = gl.matrices.projection.top();
    registers.normal_matrix = normal_matrix(registers.model_view);
    registers.normal_mode = lower_normal_mode(gl.group);
    if (registers.normal_mode == NormalMode::Rescale)
        registers.rescale = rescale_factor(registers.normal_matrix);
    return registers;
}

UserClipPlanes lower_clip_planes(const TransformGroup& gl) {
    UserClipPlanes registers;
    for (unsigned i = 0; i < ClipPlanes; ++i) {
        if (!gl.clip_plane_enable[i]) continue;
        registers.enable |= static_cast<std::uint8_t>(1u << i);
        registers.planes[i] = gl.clip_planes[i];
    }
    return registers;
}

Viewport lower_viewport(const ViewportState& gl, bool depth_clamp) {
    return {.x = static_cast<float>(gl.x),
            .y = static_cast<float>(gl.y),
            .width = static_cast<float>(gl.width),
            .height = static_cast<float>(gl.height),
            .near_depth = static_cast<float>(gl.near_depth),
            .far_depth = static_cast<float>(gl.far_depth),
            .clamp_depth = depth_clamp};
}

TexCoordSetup lower_tex_coords(const TextureUnit& unit, const Mat4& texture_matrix) {
    TexCoordSetup registers;
    for (std::size_t i = 0; i < unit.gen.size(); ++i) {
        const TexGen& gen = unit.gen[i];
        if (!gen.enabled) continue;
        registers.mode[i] = lower_gen_mode(gen.mode);
        if (gen.mode == GL_OBJECT_LINEAR) registers.plane[i] = gen.object_plane;
        if (gen.mode == GL_EYE_LINEAR) registers.plane[i] = gen.eye_plane;
    }
    registers.matrix_enable = texture_matrix != Identity4;
    registers.matrix = texture_matrix;
    return registers;
}

} // namespace ffgpu::gl
