// Bodies as lists of triangles, counter-clockwise from outside; z is up.

#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace ffgpu::gallery {

struct MeshVertex {
    glm::dvec3 position, normal;
    glm::dvec2 uv{0};
};
using Triangle = std::array<MeshVertex, 3>;
using Mesh = std::vector<Triangle>;

// An ellipsoid around the origin; a sphere if the radii are equal. (u, v) = (turn around z, angle
// from +z over pi). The poles are left out by a millionth, so that each vertex has a turn.
Mesh ellipsoid(const glm::dvec3& radii, int slices, int stacks);
inline Mesh sphere(double radius, int slices, int stacks) {
    return ellipsoid(glm::dvec3(radius), slices, stacks);
}
// From -half to half, each side in cells x cells squares; (u, v) is [0, 1] on each side.
Mesh cube(double half, int cells);
// z = 0, from (-half, -half) to (half, half), normal +z, (u, v) from 0 to 1.
Mesh square(double half, int cells);

// By glBegin(GL_TRIANGLES), with normals and texture coordinates of unit 0.
void draw_mesh(const Mesh& mesh);
// A rectangle in the plane of x and y, with (u, v) from 0 to `repeats`.
void draw_rectangle(double left, double bottom, double right, double top, double repeats = 1);

} // namespace ffgpu::gallery
