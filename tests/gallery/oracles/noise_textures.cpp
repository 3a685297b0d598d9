#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/noise.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

constexpr double TwoPi = 2 * std::numbers::pi;

// 24 cosines of frequencies between 3 and 6: radius by area, direction, phase.
double waves(const glm::dvec2& p) {
    Draws draws(1);
    double sum = 0;
    for (int i = 0; i < 24; ++i) {
        const double radius = std::sqrt(9 + 27 * draws.unit());
        const double direction = TwoPi * draws.unit(), phase = TwoPi * draws.unit();
        const double a = radius * std::cos(direction), b = radius * std::sin(direction);
        sum += std::cos(a * p.x + b * p.y + phase) / 24;
    }
    return sum;
}

double value_at(int panel, const glm::dvec3& p) {
    switch (panel) {
    case 0:
        return 0.5 + 1.5 * waves(glm::dvec2(p));
    case 1:
        return 0.5 + 0.9 * gradient_noise(2, p);
    case 2:
        return 1.3 * turbulent(2, 0.7 * p, 5);
    default: {
        const double along = (0.8 * p.x + 0.6 * p.y) / 1.6;
        return 0.5 + 0.5 * std::sin(TwoPi * along + 5 * turbulent(2, p, 5));
    }
    }
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 2);
        const glm::dvec3 point(place.pixel / 24.0, 0.37);
        return Color(std::clamp(value_at(place.panel, point), 0.0, 1.0));
    };
}

} // namespace

Claim noise_textures_claim() {
    return {
        "T21",
        "d = sum c_i cos(a_i x + b_i y + phi_i), r <= |(a_i, b_i)| <= R; n(p) = sum w(dx) w(dy) "
        "w(dz) (g . d), w(t) = 2|t|^3 - 3t^2 + 1; turbulence = sum |n(2^i p)| / 2^i; stripes = (1 "
        "+ sin(2 pi x / w + swing turbulence)) / 2",
        oracle,
        0,
        0.51,
        0.3,
        "a texel a pixel: only the rounding to 8 bits",
        "three octaves instead of five"};
}

} // namespace ffgpu::gallery
