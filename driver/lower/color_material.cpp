#include "driver/lower/color_material.h"

namespace ffgpu::gl {

std::uint8_t tracked_colors(const ColorMaterialState& color_material, unsigned face) {
    if (!color_material.enable) return 0;
    if (color_material.face == (face == 0 ? GL_BACK : GL_FRONT)) return 0;
    switch (color_material.mode) {
    case GL_AMBIENT:
        return ColorMaterialAmbient;
    case GL_DIFFUSE:
        return ColorMaterialDiffuse;
    case GL_SPECULAR:
        return ColorMaterialSpecular;
    case GL_EMISSION:
        return ColorMaterialEmission;
    default:
        return ColorMaterialAmbient | ColorMaterialDiffuse;
    }
}

void track_color(LightingState& lighting, const Vec4& current_color) {
    for (unsigned face = 0; face < 2; ++face) {
        const std::uint8_t tracked = tracked_colors(lighting.color_material, face);
        MaterialFace& material = lighting.materials[face];
        if (tracked & ColorMaterialAmbient) material.ambient = current_color;
        if (tracked & ColorMaterialDiffuse) material.diffuse = current_color;
        if (tracked & ColorMaterialSpecular) material.specular = current_color;
        if (tracked & ColorMaterialEmission) material.emission = current_color;
    }
}

} // namespace ffgpu::gl
