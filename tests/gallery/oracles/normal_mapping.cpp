#include "tests/gallery/harness/heights.h"
#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/relief.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

const Color Background(0.1);

Color plate(const techniques::Field& heights, const Eye& eye, const glm::dvec3& ray) {
    const glm::dvec3 place = eye.position - eye.position.z / ray.z * ray;
    if (ray.z >= 0 || std::abs(place.x) > 1 || std::abs(place.y) > 1) return Background;
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.5, 0.4, 0.7) - place);
    const glm::dvec3 normal = normal_between(heights, (glm::dvec2(place) + 1.0) / 2.0, 7);
    return Color(std::clamp(glm::dot(normal, light), 0.0, 1.0));
}

Color ball(const Eye& eye, const glm::dvec3& ray) {
    const auto distance = hit_ellipsoid(eye.position, ray, glm::dvec3(1));
    if (!distance) return Background;
    const glm::dvec3 n = eye.position + *distance * ray;
    const double theta = std::acos(n.z), phi = std::atan2(n.y, n.x);
    const glm::dvec3 around = glm::normalize(glm::dvec3(-n.y, n.x, 0));
    const glm::dvec3 down = glm::cross(around, n);
    const glm::dvec3 dimpled =
        glm::normalize(n + 0.4 * std::sin(16 * phi) * std::sin(theta) * around +
                       0.4 * std::sin(16 * theta) * down);
    return Color(std::clamp(glm::dot(dimpled, glm::dvec3(0.36, -0.8, 0.48)), 0.0, 1.0));
}

Oracle oracle() {
    return [heights = hills(64)](const glm::dvec2& window) {
        static const Eye eye({0, -2.4, 2.4}, {0, 0, 0}, {0, 0, 1}, {48, 160.0 / 240});
        const Place place = place_in(window, 2, 1);
        const glm::dvec3 ray = eye.ray(place.unit);
        return place.panel == 0 ? plate(heights, eye, ray) : ball(eye, ray);
    };
}

} // namespace

Claim normal_mapping_claim() {
    return {
        "T15",
        "colour = max(n . l, 0), n of the map, l = M^T (lamp - p) / |lamp - p|, M = (t, b, m); the "
        "combiner: 4 sum (a_i - 1/2)(b_i - 1/2)",
        oracle,
        1.0 / 8,
        30,
        0.9,
        "normal and light have 8 bits a component (1/127 each); the filter's mean of two normals "
        "is shorter than 1; at the ball's poles the turn runs through all values",
        "no normalisation cube map: the light's colour is interpolated between the corners"};
}

} // namespace ffgpu::gallery
