#include "tests/gallery/harness/meshes.h"

#include "tests/gallery/harness/opengl.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace ffgpu::gallery {
namespace {

using Surface = std::function<MeshVertex(double, double)>;

// The surface over [0, 1] x [0, 1], seen counter-clockwise where u runs right and v up.
void add_patch(Mesh& mesh, const Surface& surface, int columns, int rows) {
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double u0 = static_cast<double>(column) / columns;
            const double u1 = static_cast<double>(column + 1) / columns;
            const double v0 = static_cast<double>(row) / rows;
            const double v1 = static_cast<double>(row + 1) / rows;
            const MeshVertex a = surface(u0, v0), b = surface(u1, v0);
            const MeshVertex c = surface(u1, v1), d = surface(u0, v1);
            mesh.push_back({a, b, c});
            mesh.push_back({a, c, d});
        }
    }
}

} // namespace

Mesh ellipsoid(const glm::dvec3& radii, int slices, int stacks) {
    constexpr double Pole = 1e-6;
    Mesh mesh;
    const auto surface = [&](double u, double upwards) {
        const double phi = (2 * u - 1) * std::numbers::pi;
        const double theta =
            std::clamp((1 - upwards) * std::numbers::pi, Pole, std::numbers::pi - Pole);
        const glm::dvec3 unit(
            std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
        return MeshVertex{unit * radii, glm::normalize(unit / radii), {u, 1 - upwards}};
    };
    add_patch(mesh, surface, slices, stacks);
    return mesh;
}

Mesh cube(double half, int cells) {
    Mesh mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
            const auto surface = [&](double u, double v) {
                glm::dvec3 position, normal(0);
                normal[axis] = sign;
                position[axis] = sign * half;
                position[(axis + 1) % 3] = (2 * u - 1) * sign * half;
                position[(axis + 2) % 3] = (2 * v - 1) * half;
                return MeshVertex{position, normal, {u, v}};
            };
            add_patch(mesh, surface, cells, cells);
        }
    }
    return mesh;
}

Mesh square(double half, int cells) {
    Mesh mesh;
    const auto surface = [&](double u, double v) {
        return MeshVertex{{(2 * u - 1) * half, (2 * v - 1) * half, 0}, {0, 0, 1}, {u, v}};
    };
    add_patch(mesh, surface, cells, cells);
    return mesh;
}

void draw_mesh(const Mesh& mesh) {
    glBegin(GL_TRIANGLES);
    for (const Triangle& triangle : mesh) {
        for (const MeshVertex& vertex : triangle) {
            glNormal3dv(glm::value_ptr(vertex.normal));
            glTexCoord2dv(glm::value_ptr(vertex.uv));
            glVertex3dv(glm::value_ptr(vertex.position));
        }
    }
    glEnd();
}

void draw_rectangle(double left, double bottom, double right, double top, double repeats) {
    glBegin(GL_QUADS);
    glTexCoord2d(0, 0);
    glVertex2d(left, bottom);
    glTexCoord2d(repeats, 0);
    glVertex2d(right, bottom);
    glTexCoord2d(repeats, repeats);
    glVertex2d(right, top);
    glTexCoord2d(0, repeats);
    glVertex2d(left, top);
    glEnd();
}

} // namespace ffgpu::gallery
