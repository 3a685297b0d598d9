// The surroundings that shiny things reflect: a colour for each direction.

#pragma once

#include "tests/gallery/harness/images.h"

#include <array>

#include <glm/vec3.hpp>

namespace ffgpu::gallery {

// Red, green and blue in [0, 1]. Smooth: a sky, a ground and two lamps; z is up.
glm::dvec3 environment(const glm::dvec3& direction);

// It as six faces in OpenGL's order, and as a sphere map seen along -z by an eye.
std::array<Image, 6> environment_cube(int size);
Image environment_sphere_map(int size);

} // namespace ffgpu::gallery
