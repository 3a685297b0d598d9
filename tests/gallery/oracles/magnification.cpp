#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

Oracle oracle() {
    return [image = random_colours(8, 7)](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 1);
        const glm::dvec2 at = place.pixel - glm::dvec2(95, 40);
        const double c = std::cos(std::numbers::pi / 9), s = std::sin(std::numbers::pi / 9);
        const glm::dvec2 uv((c * at.x + s * at.y + 60) / 120, (c * at.y - s * at.x) / 160);
        if (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return Color(0.1);
        return place.panel == 0 ? nearest(image, uv) : bilinear_clamped(image, uv);
    };
}

} // namespace

Claim magnification_claim() {
    return {"T5",
            "nearest: u[round(x - 1/2)]; bilinear: lerp(t, lerp(s, u00, u10), lerp(s, u01, u11)), "
            "lerp(x, a, b) = a + x (b - a)",
            oracle,
            1.0 / 8,
            1.5,
            0.5,
            "weights of 8 bits, and each lerp rounds to 8 bits",
            "the right rectangle takes the nearest texel, too"};
}

} // namespace ffgpu::gallery
