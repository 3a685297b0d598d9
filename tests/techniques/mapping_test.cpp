// Mappings against points whose coordinates are known.

#include "techniques/mapping.h"

#include <cmath>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ffgpu::techniques {
namespace {

bool near(const glm::dvec2& a, const glm::dvec2& b) {
    return glm::length(a - b) < 1e-12;
}

TEST_CASE("spherical coordinates: the seeds' quarter turns, and both poles") {
    const glm::dvec3 centre(1, 2, 3);
    CHECK(near(spherical(centre, centre + glm::dvec3(2, 0, 0)), {0.5, 0.5}));
    CHECK(near(spherical(centre, centre + glm::dvec3(0, 2, 0)), {0.75, 0.5}));
    CHECK(near(spherical(centre, centre + glm::dvec3(0, -2, 0)), {0.25, 0.5}));
    CHECK(near(spherical(centre, centre + glm::dvec3(-2, 0, 0)), {1, 0.5}));
    CHECK(spherical(centre, centre + glm::dvec3(0, 0, 5)).y == 0);
    CHECK(spherical(centre, centre - glm::dvec3(0, 0, 5)).y == 1);
    CHECK(spherical(centre, centre) == glm::dvec2(0.5, 0.5));
    CHECK(near(normal_on_sphere({0, 1, 1}), {0.75, 0.25}));
}

TEST_CASE("a cylinder takes the turn and the height") {
    const Cylinder cylinder{{1, 0, 0}, 2, 6};
    CHECK(near(cylindrical(cylinder, {1, 3, 3}), {0.75, 0.25}));
    CHECK(near(cylindrical(cylinder, {2, 0, 7}), {0.5, 1.25}));
}

TEST_CASE("planes: parallel rays keep lengths, a projector divides, and has no picture behind it") {
    const glm::dmat4 rows = glm::transpose(
        glm::dmat4(2, 0, 0, 1, 0, 0, 3, 0, 0, 0, 0, 0, 0, 1, 0, 0)); // u~ = 2x + 1, v~ = 3z, w = y
    CHECK(near(planar_orthographic(rows, {1, 9, 2}), {3, 6}));
    CHECK(near(planar_perspective(rows, {1, 2, 2}).value(), {1.5, 3}));
    CHECK_FALSE(planar_perspective(rows, {1, 0, 2}));
    CHECK_FALSE(planar_perspective(rows, {1, -1, 2}));
}

TEST_CASE("each side of the box shows its corners where one who looks at it sees them") {
    const glm::dvec3 half(1, 2, 3);
    for (int side = 0; side < 6; ++side) {
        const auto face = static_cast<BoxFace>(side);
        glm::dvec3 outwards(0);
        outwards[side / 2] = side % 2 ? -1 : 1;
        CHECK(box_face(outwards) == face);
        const glm::dvec3 up = side < 4 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
        const glm::dvec3 right = glm::cross(up, outwards);
        const glm::dvec3 centre = outwards * half;
        CHECK(near(box(face, half, centre), {0.5, 0.5}));
        CHECK(near(box(face, half, centre + right * half), {1, 0.5}));
        CHECK(near(box(face, half, centre + up * half), {0.5, 1}));
    }
    CHECK(box_face({-1, 1, 1}) == BoxFace::NegativeX);
    CHECK(box_face({0, 1, -1}) == BoxFace::PositiveY);
}

TEST_CASE("a triangle at the seam goes on beyond 1 instead of running back") {
    CHECK(across_seam({0.95, 0.05, 0.98}) == std::array{0.95, 1.05, 0.98});
    CHECK(across_seam({0.3, 0.6, 0.7}) == std::array{0.3, 0.6, 0.7});
    CHECK(across_seam({0.0, 0.5, 0.25}) == std::array{0.0, 0.5, 0.25}); // half a turn is none
}

TEST_CASE("the three ways to a proxy differ, each as its ray meets the proxy") {
    const glm::dvec3 point(1, 0, 1), normal = glm::normalize(glm::dvec3(1, 0, 3));
    const ProxyObject cylinder{Proxy::Cylinder, 2};
    // From z = -4 to 4. Straight out: z = 1; along the normal 3 upwards; from the centre z = 2.
    CHECK(near(by_proxy(cylinder, ProxyWay::ProxyNormal, point, normal), {0.5, 5.0 / 8}));
    CHECK(near(by_proxy(cylinder, ProxyWay::TargetNormal, point, normal), {0.5, 1}));
    CHECK(near(by_proxy(cylinder, ProxyWay::CentreRay, point, normal), {0.5, 6.0 / 8}));
    const ProxyObject sphere{Proxy::Sphere, 5};
    // (1, 0, 1) + t (1, 0, 0) meets radius 5 at x^2 = 24.
    const double theta = std::acos(1.0 / 5) / 3.14159265358979323846;
    CHECK(near(by_proxy(sphere, ProxyWay::TargetNormal, point, {1, 0, 0}), {0.5, theta}));
    const ProxyObject crate{Proxy::Box, 2};
    CHECK(near(by_proxy(crate, ProxyWay::CentreRay, {1, 0.5, 0}, normal), {0.75, 0.5}));
    CHECK(near(by_proxy(crate, ProxyWay::ProxyNormal, {1, 0.5, 0}, normal), {0.625, 0.5}));
}

} // namespace
} // namespace ffgpu::techniques
