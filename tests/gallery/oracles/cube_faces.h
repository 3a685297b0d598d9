// A cube map's look-up by OpenGL 1.5, table 3.19, in real numbers; each face is clamped to its
// edges.

#pragma once

#include "tests/gallery/harness/environment.h"
#include "tests/gallery/oracles/oracle.h"

#include <array>

namespace ffgpu::gallery {

Color cube_lookup(const std::array<Image, 6>& faces, const glm::dvec3& direction);

} // namespace ffgpu::gallery
