#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/cube_faces.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

Color looked_up(int panel, const glm::dvec3& r) {
    static const std::array<Image, 6> coarse_cube = environment_cube(16);
    static const Image coarse_ball = environment_sphere_map(32);
    if (panel < 2) return environment(r); // enough texels: the surroundings themselves
    if (panel == 2) return cube_lookup(coarse_cube, r);
    const double m = 2 * std::sqrt(r.x * r.x + r.y * r.y + (r.z + 1) * (r.z + 1));
    return bilinear_clamped(coarse_ball, glm::dvec2(r) / m + 0.5);
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 2);
        static const Eye eye({0, 0, 4.2}, {0, 0, 0}, {0, 1, 0}, {32, 160.0 / 120});
        const glm::dvec3 ray = glm::normalize(eye.ray(place.unit));
        const auto distance = hit_ellipsoid(eye.position, ray, glm::dvec3(1));
        if (!distance) return Color(0.1);
        const glm::dvec3 normal = eye.position + *distance * ray;
        return looked_up(place.panel, ray - 2 * glm::dot(ray, normal) * normal);
    };
}

} // namespace

Claim sphere_map_environment_claim() {
    return {"T14",
            "s = rx / m + 1/2, t = ry / m + 1/2, m = 2 sqrt(rx^2 + ry^2 + (rz + 1)^2)",
            oracle,
            1.0 / 8,
            3,
            0.6,
            "above, the surroundings' own formula: the sphere map's texels lie ever further apart "
            "towards the rim; coordinates are linear between vertices",
            "the cube map is looked up by the normal instead of the reflection"};
}

} // namespace ffgpu::gallery
