#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/noise.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

const Color Background(0.1);
constexpr double Pi = std::numbers::pi;

Color marble(const glm::dvec3& place) {
    const glm::dvec3 p = 1.5 * place;
    const double phase = 2 * Pi * (0.6 * p.x + 0.8 * p.z) / 0.7 + 2.5 * turbulent(4, p, 2);
    const double vein = 0.5 + 0.5 * std::sin(phase);
    return glm::mix(Color(0.95), Color(0.25, 0.35, 0.3), vein * vein);
}

struct Sample {
    Color color;
    double alpha;
};

Sample cloud(glm::dvec3 p) {
    p = glm::clamp(p, -1.0 + 1.0 / 64, 1.0 - 1.0 / 64); // the centres of the outermost texels
    const glm::dvec3 a = p - glm::dvec3(0.25, 0.1, 0.2), b = p + glm::dvec3(0.3, 0.15, 0.1);
    const double warm = std::exp(-9 * glm::dot(a, a)), cold = std::exp(-14 * glm::dot(b, b));
    const double sum = warm + cold + 1e-9;
    const Color color = (warm * Color(1, 0.5, 0.1) + cold * Color(0.2, 0.5, 1)) / sum;
    return {color, 0.3 * std::min(1.0, sum)};
}

// All slices from the farthest to the nearest, where the ray meets them.
Color volume(const Eye& eye, const glm::dvec3& ray) {
    Color color = Background;
    const double angle = 35 * Pi / 180;
    for (int i = 0; i < 48; ++i) {
        const double z = 2 * (i + 0.5) / 48 - 1;
        const glm::dvec3 p = eye.position + (z - eye.position.z) / ray.z * ray;
        if (std::abs(p.x) > 1 || std::abs(p.y) > 1) continue;
        const Sample sample = cloud({std::cos(angle) * p.x + std::sin(angle) * p.z,
                                     p.y,
                                     std::cos(angle) * p.z - std::sin(angle) * p.x});
        color = sample.alpha * sample.color + (1 - sample.alpha) * color;
    }
    return color;
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        static const Eye eye({0, 0, 4.5}, {0, 0, 0}, {0, 1, 0}, {38, 160.0 / 240});
        const Place place = place_in(window, 2, 1);
        const glm::dvec3 ray = eye.ray(place.unit);
        if (place.panel == 1) return volume(eye, ray);
        const auto distance = hit_ellipsoid(eye.position, ray, glm::dvec3(0.97));
        return distance ? marble(eye.position + *distance * ray) : Background;
    };
}

} // namespace

Claim solid_textures_claim() {
    return {"T23",
            "colour = f(x, y, z); volume: C = a c + (1 - a) C for each slice, from back to front",
            oracle,
            1.0 / 8,
            90,
            1.8,
            "64^3 texels smooth the noise's creases; 48 blends round to 8 bits; at the ball's rim "
            "the depth changes "
            "by a twentieth of the radius within a tenth of a pixel",
            "only the farther half of the slices"};
}

} // namespace ffgpu::gallery
