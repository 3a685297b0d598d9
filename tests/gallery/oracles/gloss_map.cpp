#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

constexpr double Pi = std::numbers::pi;
const glm::dvec3 Light(0.48, 0.64, 0.6);

Oracle oracle() {
    return [colors = waves(128), gloss = slide(64)](const glm::dvec2& window) {
        static const Eye eye({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, {34, 4.0 / 3});
        const glm::dvec3 ray = eye.ray(place_in(window, 1, 1).unit);
        const auto distance = hit_ellipsoid(eye.position, ray, glm::dvec3(1));
        if (!distance) return Color(0.1);
        const glm::dvec3 n = eye.position + *distance * ray;
        // Back out of the turn by -65 degrees around x, to the ball's own axis.
        const double c = std::cos(65 * Pi / 180), s = std::sin(65 * Pi / 180);
        const glm::dvec3 own(n.x, c * n.y - s * n.z, s * n.y + c * n.z);
        const glm::dvec2 uv((std::atan2(own.y, own.x) + Pi) / (2 * Pi), std::acos(own.z) / Pi);

        const double diffuse = std::max(0.0, glm::dot(n, Light));
        const glm::dvec3 half = glm::normalize(Light + glm::dvec3(0, 0, 1));
        const double specular =
            diffuse > 0 ? std::pow(std::max(0.0, glm::dot(n, half)), 12.0) : 0.0;
        return clamped(diffuse * bilinear(colors, uv) +
                       specular * bilinear(gloss, uv * glm::dvec2(6, 3)));
    };
}

} // namespace

Claim gloss_map_claim() {
    return {
        "T26",
        "colour = (n . l) diffuse(u, v) + (n . h)^shininess gloss(u, v)",
        oracle,
        1.0 / 8,
        14,
        0.7,
        "light is computed at the vertices of 128 x 64 cells; products and the sum have 8 bits; at "
        "a pole the turn runs through all values within one cell",
        "the same gloss everywhere"};
}

} // namespace ffgpu::gallery
