// Surfaces with fine relief (T15 to T17): from heights to normals, the frames that they are told
// in, and vertices that really move.
//
// Heights and lengths are in the same unit; texels are apart by 1/width and 1/height of the texture
// coordinates. Source: Blinn 1978, "Simulation of Wrinkled Surfaces"; Kilgard 2000, "A Practical
// and Robust Bump-mapping Technique for Today's GPUs".

#pragma once

#include "techniques/image.h"

#include <array>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ffgpu::techniques {

// A component of [-1, 1] as a byte: round(255 (n + 1) / 2). The combiner's dot product reads it
// back as byte / 255 - 1/2, twice.
std::array<std::uint8_t, 3> encode_normal(const glm::dvec3& normal);

// n = (-c dh/du, -c dh/dv, 1) normalised, in tangent space: dh/du by central differences of texels,
// (h(i+1) - h(i-1)) / 2, so a height counts in texel widths; c scales it. The field repeats.
glm::dvec3 normal_of_height(const Field& heights, int x, int y, double scale);
Texels normal_map(const Field& heights, double scale);

// Six faces of size x size texels in OpenGL's order (+x, -x, +y, -y, +z, -z): each texel holds its
// own direction, encoded and of unit length, so that a look-up normalises.
std::array<Texels, 6> normalisation_cube_map(int size);
// The direction of the centre of texel (x, y) of a face, not normalised: its largest component
// is 1. Equation and table 3.19 of OpenGL 1.5 backwards.
glm::dvec3 cube_texel_direction(int face, int size, int x, int y);

// A corner of a triangle.
struct Corner {
    glm::dvec3 position;
    glm::dvec2 uv;
};
// t along p_u, b = m x t, m = normal: orthonormal, so that columns (t, b, m) carry tangent space to
// object space, and the transpose carries directions into tangent space. p_u of the plane through
// the corners; if (u, v) is degenerate, any t perpendicular to m.
glm::dmat3 tangent_frame(const std::array<Corner, 3>& triangle, const glm::dvec3& normal);
// The same from p_u itself, where the surface is known as a formula.
glm::dmat3 tangent_frame(const glm::dvec3& p_u, const glm::dvec3& normal);

// Bilinear, texel centres at half integers, repeating.
double height_at(const Field& heights, const glm::dvec2& uv);
// p' = p + scale h(uv) n: the vertex moves along its unit normal.
glm::dvec3
displaced(const Corner& corner, const glm::dvec3& normal, const Field& heights, double scale);

} // namespace ffgpu::techniques
