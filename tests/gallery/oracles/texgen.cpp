#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/cube_faces.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

// Eye coordinates: the ball of radius 1 stands at z = -4.2.
const glm::dvec3 Centre(0, 0, -4.2);

// Out of the object's turns by 40 degrees around z, and 25 around x, back into its own coordinates.
glm::dvec3 in_object(const glm::dvec3& p) {
    const double z = 40 * std::numbers::pi / 180, x = 25 * std::numbers::pi / 180;
    const glm::dvec3 q(
        std::cos(z) * p.x + std::sin(z) * p.y, std::cos(z) * p.y - std::sin(z) * p.x, p.z);
    return {q.x, std::cos(x) * q.y + std::sin(x) * q.z, std::cos(x) * q.z - std::sin(x) * q.y};
}

// The 3-D texture is linear in each axis between the centres of its first and last texel.
Color cells(const glm::dvec3& p) {
    return (30.0 + 28.0 * glm::clamp(8.0 * p - 0.5, 0.0, 7.0)) / 255.0;
}

Color looked_up(int panel, const glm::dvec3& place, const glm::dvec3& normal) {
    static const Image picture = waves(128);
    static const std::array<Image, 6> cube = environment_cube(64);
    const glm::dvec3 ray = glm::normalize(place);
    const glm::dvec3 r = ray - 2 * glm::dot(normal, ray) * normal;
    const glm::dvec3 object = in_object(place - Centre);
    switch (panel) {
    case 0:
        return bilinear(picture, glm::dvec2(object));
    case 1:
        return bilinear(picture, glm::dvec2(place));
    case 2: {
        const double m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
        return bilinear(picture, glm::dvec2(r) / m + 0.5);
    }
    case 3:
        return cube_lookup(cube, r);
    case 4:
        return cube_lookup(cube, normal);
    default:
        return cells(object);
    }
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        const Place place = place_in(window, 3, 2);
        if (place.panel > 5 || place.unit.x > 1) return Color(0.1);
        static const Eye eye({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, {32, 106.0 / 120});
        const glm::dvec3 ray = eye.ray(place.unit);
        const auto distance = hit_ellipsoid(-Centre, ray, glm::dvec3(1));
        if (!distance) return Color(0.1);
        const glm::dvec3 point = *distance * ray;
        return looked_up(place.panel, point, point - Centre);
    };
}

} // namespace

Claim texgen_claim() {
    return {"T11",
            "object linear: plane . p_object; eye linear: plane . p_eye; sphere map: r / m + 1/2, "
            "m = 2 "
            "sqrt(rx^2 + ry^2 + (rz + 1)^2); reflection: r = i - 2 (n . i) n; normal: n of the eye",
            oracle,
            1.0 / 8,
            16,
            0.6,
            "coordinates are linear between the vertices of a mesh of 96 x 48 cells",
            "the second panel generates in object coordinates"};
}

} // namespace ffgpu::gallery
