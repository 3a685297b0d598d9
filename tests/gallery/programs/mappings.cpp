// Texture coordinates from geometry, a formula at each vertex. Top: orthographic and perspective
// planes, a cylinder. Middle: a sphere; a box; the normal projected onto a sphere. Bottom: a
// cylinder as proxy of an ellipsoid, by the proxy's normal, the target's normal, and rays from the
// centre.

#include "techniques/mapping.h"
#include "tests/gallery/harness/meshes.h"
#include "tests/gallery/harness/textures.h"
#include "tests/gallery/programs/programs.h"

#include <cmath>
#include <functional>
#include <numbers>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

namespace ffgpu::gallery {
namespace {

using namespace techniques;
using Mapping = std::function<glm::dvec2(const MeshVertex&)>;

void draw_mapped(const Mesh& mesh, const Mapping& mapping, bool closed) {
    glBegin(GL_TRIANGLES);
    for (const Triangle& triangle : mesh) {
        std::array<glm::dvec2, 3> uv;
        for (std::size_t i = 0; i < 3; ++i)
            uv[i] = mapping(triangle[i]);
        const std::array<double, 3> around{uv[0].x, uv[1].x, uv[2].x};
        const auto u = closed ? across_seam(around) : around;
        for (std::size_t i = 0; i < 3; ++i) {
            glTexCoord2d(u[i], uv[i].y);
            glVertex3dv(glm::value_ptr(triangle[i].position));
        }
    }
    glEnd();
}

// Without its poles, where rays leave along the proxy's axis.
Mesh barrel(const Mesh& egg) {
    Mesh kept;
    const double highest = 0.9 * std::cos(std::numbers::pi / 6) + 1e-9;
    for (const Triangle& triangle : egg) {
        bool within = true;
        for (const MeshVertex& vertex : triangle)
            within = within && std::abs(vertex.position.z) <= highest;
        if (within) kept.push_back(triangle);
    }
    return kept;
}

// Looks at the origin from a little above.
void look(const Panel& place) {
    enter(place);
    glMatrixMode(GL_PROJECTION);
    gluPerspective(32, place.aspect(), 1, 20);
    glMatrixMode(GL_MODELVIEW);
    gluLookAt(1.2, -4.2, 1.4, 0, 0, 0, 0, 0, 1);
}

// Rows of (u~, v~, *, w): a slide projector at y = -3 that looks along +y.
const glm::dmat4 Slide =
    glm::transpose(glm::dmat4(1, 0.5, 0, 1.5, 0, 0.5, 1, 1.5, 0, 0, 0, 0, 0, 1, 0, 3));
// u and v from a plane that leans.
const glm::dmat4 Plane =
    glm::transpose(glm::dmat4(0.5, 0.1, 0, 0.5, 0, 0.1, 0.5, 0.5, 0, 0, 0, 0, 0, 0, 0, 1));

glm::dvec2 boxed(const MeshVertex& vertex) {
    return box(box_face(vertex.normal), glm::dvec3(0.8), vertex.position);
}

Mapping proxy(ProxyWay way) {
    return [way](const MeshVertex& vertex) {
        return by_proxy({Proxy::Cylinder, 1.5}, way, vertex.position, vertex.normal);
    };
}

std::vector<Mapping> ways(bool broken) {
    const glm::dvec3 centre(0);
    const double top = broken ? 0.8 : 1; // The cylinder is taken for shorter than it is.
    return {
        [](const MeshVertex& v) { return planar_orthographic(Plane, v.position); },
        [](const MeshVertex& v) { return planar_perspective(Slide, v.position).value(); },
        [=](const MeshVertex& v) {
            return cylindrical({centre, -1, top}, v.position);
        },
        [=](const MeshVertex& v) { return spherical(centre, v.position); },
        boxed,
        [](const MeshVertex& v) { return normal_on_sphere(v.normal); },
        proxy(ProxyWay::ProxyNormal),
        proxy(ProxyWay::TargetNormal),
        proxy(ProxyWay::CentreRay),
    };
}

} // namespace

void mappings(const Scene& scene) {
    clear(0.1f, 0.1f, 0.1f);
    glEnable(GL_TEXTURE_2D);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    texture_2d(waves(128));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);

    const Mesh ball = sphere(1, 96, 48), egg = ellipsoid({1.1, 0.6, 0.9}, 96, 48);
    const Mesh crate = cube(0.8, 1), cut = barrel(egg);
    const Mesh* const bodies[] = {&ball, &ball, &ball, &ball, &crate, &egg, &cut, &cut, &cut};
    const std::vector<Mapping> all = ways(scene.broken);
    for (int i = 0; i < 9; ++i) {
        look(panel(scene, i, 3, 3));
        const bool closed = i == 2 || i == 3 || i > 4; // u runs around the body
        draw_mapped(*bodies[i], all[static_cast<std::size_t>(i)], closed);
    }
}

} // namespace ffgpu::gallery
