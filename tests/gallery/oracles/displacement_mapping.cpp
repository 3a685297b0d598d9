#include "tests/gallery/harness/heights.h"
#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/relief.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

constexpr double Pi = std::numbers::pi;

glm::dvec2 turn_and_height(const glm::dvec3& p) {
    return {(std::atan2(p.y, p.x) + Pi) / (2 * Pi), std::acos(p.z / glm::length(p)) / Pi};
}

// How far the point lies outside of the displaced ball.
double outside(const techniques::Field& heights, const glm::dvec3& p) {
    return glm::length(p) - 0.8 - 0.45 * height_between(heights, turn_and_height(p));
}

// The first place on the ray that is inside, by steps and then by halving.
std::optional<glm::dvec3>
first_inside(const techniques::Field& heights, const glm::dvec3& from, const glm::dvec3& along) {
    constexpr double Reach = 1.26, Step = 0.02; // heights stay below 1
    const double middle = -glm::dot(from, along);
    if (glm::length(from + middle * along) > Reach) return std::nullopt;
    for (double t = middle - Reach; t < middle + Reach; t += Step) {
        if (outside(heights, from + t * along) > 0) continue;
        double low = t - Step, high = t;
        for (int i = 0; i < 30; ++i) {
            const double half = (low + high) / 2;
            (outside(heights, from + half * along) > 0 ? low : high) = half;
        }
        return from + high * along;
    }
    return std::nullopt;
}

Oracle oracle() {
    return [image = chart(128), heights = hills(32)](const glm::dvec2& window) {
        static const Eye eye({1.5, -3.5, 1.2}, {0, 0, 0}, {0, 0, 1}, {50, 160.0 / 240});
        const Place place = place_in(window, 2, 1);
        const glm::dvec3 ray = glm::normalize(eye.ray(place.unit));
        std::optional<glm::dvec3> point;
        if (place.panel == 1)
            point = first_inside(heights, eye.position, ray);
        else if (const auto distance = hit_ellipsoid(eye.position, ray, glm::dvec3(0.8)))
            point = eye.position + *distance * ray;
        return point ? bilinear(image, turn_and_height(*point)) : Color(0.1);
    };
}

} // namespace

Claim displacement_mapping_claim() {
    return {
        "T17",
        "p' = p + c h(u, v) n for each vertex; the rest of the pipeline is unchanged",
        oracle,
        0.5,
        200,
        1.3,
        "the mesh has 128 x 64 cells where the surface is curved: edges of hills lie up to half a "
        "pixel elsewhere",
        "the heights are scaled by 0.3 instead of 0.45"};
}

} // namespace ffgpu::gallery
