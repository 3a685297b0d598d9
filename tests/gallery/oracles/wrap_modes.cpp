#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

const Color Background(0.1), Orange(1, 0.5, 0);

// |s| mirrored at every integer: up and down between 0 and 1.
double mirrored(double s) {
    const double within = s - 2 * std::floor(s / 2);
    return within <= 1 ? within : 2 - within;
}

Color wrapped(const Image& image, int mode, const glm::dvec2& uv) {
    switch (mode) {
    case 1: {
        // Half a texel before the mirror both neighbours are the same texel.
        return bilinear_clamped(image, {mirrored(uv.x), mirrored(uv.y)});
    }
    case 2: // The coordinate stops at 0 and 1, where half of the filter lies on the border.
        return bilinear_bordered(image, glm::clamp(uv, 0.0, 1.0), Orange);
    case 3:
        return bilinear_clamped(image, uv);
    case 4:
        return bilinear_bordered(image, uv, Orange);
    default:
        return bilinear(image, uv);
    }
}

Oracle oracle() {
    return [image = chart(16)](const glm::dvec2& window) {
        const Place place = place_in(window, 3, 2);
        const glm::dvec2 unit = (place.pixel - glm::dvec2(4, 4)) / glm::dvec2(96, 112);
        if (place.panel > 5 || unit.x < 0 || unit.x > 1 || unit.y < 0 || unit.y > 1)
            return Background;
        glm::dvec2 uv = 3.0 * unit - 1.0;
        if (place.panel == 5) {
            const double angle = std::numbers::pi / 6;
            const glm::dvec2 half = 0.5 * uv;
            uv = glm::dvec2(half.x * std::cos(angle) - half.y * std::sin(angle),
                            half.x * std::sin(angle) + half.y * std::cos(angle)) +
                 0.5;
        }
        return wrapped(image, place.panel, uv);
    };
}

} // namespace

Claim wrap_modes_claim() {
    return {
        "T2",
        "repeat: u - floor(u); mirrored: |u - 2 round(u/2)|; clamp: min(max(u, 0), 1), half of the "
        "filter on the border; clamp to edge: the texels at the edge go on; to border: a colour",
        oracle,
        1.0 / 16,
        1.5,
        0.4,
        "weights of 8 bits, each of three interpolations rounds to 8 bits",
        "the mirrored panel repeats instead"};
}

} // namespace ffgpu::gallery
