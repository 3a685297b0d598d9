#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

// Keys' interpolating cubic, a = -1/2.
double weight(double distance) {
    const double d = std::fabs(distance);
    if (d < 1) return 1.5 * d * d * d - 2.5 * d * d + 1;
    return d < 2 ? -0.5 * d * d * d + 2.5 * d * d - 4 * d + 2 : 0;
}

Color bicubic_clamped(const Image& image, const glm::dvec2& uv) {
    const double u = uv.x * image.width - 0.5, v = uv.y * image.height - 0.5;
    const int left = static_cast<int>(std::floor(u)) - 1, low = static_cast<int>(std::floor(v)) - 1;
    Color sum(0.0);
    for (int y = low; y < low + 4; ++y)
        for (int x = left; x < left + 4; ++x)
            sum +=
                weight(u - x) * weight(v - y) *
                texel(image, std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    return glm::clamp(sum, 0.0, 1.0);
}

Oracle oracle() {
    return [image = random_colours(8, 7)](const glm::dvec2& window) {
        const Place place = place_in(window, 3, 1);
        const glm::dvec2 at = place.pixel - glm::dvec2(65, 40);
        const double c = std::cos(std::numbers::pi / 9), s = std::sin(std::numbers::pi / 9);
        const glm::dvec2 uv((c * at.x + s * at.y + 40) / 80, (c * at.y - s * at.x) / 160);
        if (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return Color(0.1);
        if (place.panel == 0) return nearest(image, uv);
        return place.panel == 1 ? bilinear_clamped(image, uv) : bicubic_clamped(image, uv);
    };
}

} // namespace

Claim magnification_claim() {
    return {
        "T5",
        "nearest: u[round(x - 1/2)]; bilinear: lerp(t, lerp(s, u00, u10), lerp(s, u01, u11)), "
        "lerp(x, a, b) = a + x (b - a); bicubic: sum of w(x - i) w(y - j) u[i, j], w Keys' cubic",
        oracle,
        1.0 / 8,
        1.5,
        0.5,
        "weights of 8 and 10 bits, and each lerp rounds to 8 bits",
        "the middle and right rectangles take the nearest texel, too"};
}

} // namespace ffgpu::gallery
