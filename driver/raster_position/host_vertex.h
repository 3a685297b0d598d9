// One vertex through transformation, lighting and texture coordinate generation on the host: the
// raster position is such a vertex, which no draw carries (GL 1.5, 2.13).

#pragma once

#include "model/device/registers.h"

#include <array>

namespace ffgpu::gl {

struct EyeVertex {
    Vec4 position{}; // in eye coordinates
    std::array<float, 3> normal{};
    Vec4 clip{};
};

EyeVertex transform_vertex(const Registers& registers, const Vec4& object, const Vec4& normal);

// Inside of the view volume and of the enabled clip planes.
bool is_inside(const Registers& registers, const EyeVertex& vertex);

struct LitColors {
    Vec4 primary{}, secondary{0, 0, 0, 1}; // clamped
};
// The colours of a vertex that faces the viewer (GL 1.5, 2.14.1); without lighting the given ones.
LitColors light_vertex(const Registers& registers,
                       const EyeVertex& vertex,
                       const Vec4& color,
                       const Vec4& secondary_color);

// Texture coordinates of a unit, generated and transformed.
Vec4 texture_coordinates(const TexCoordSetup& setup,
                         const Vec4& object,
                         const EyeVertex& vertex,
                         const Vec4& current);

} // namespace ffgpu::gl
