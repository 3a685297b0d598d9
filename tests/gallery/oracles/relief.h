// Heights and normals of a field, as the oracles compute them.

#pragma once

#include "techniques/image.h"
#include "tests/gallery/oracles/space.h"

namespace ffgpu::gallery {

double height_between(const techniques::Field& heights, const glm::dvec2& uv);
// Unit normals (-c dh/du, -c dh/dv, 1) of the four texels around, central differences,
// interpolated.
glm::dvec3 normal_between(const techniques::Field& heights, const glm::dvec2& uv, double scale);

} // namespace ffgpu::gallery
