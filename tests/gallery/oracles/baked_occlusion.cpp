#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

// The share of the sky that a wall hides from a level point `x` before it: the form factor of a
// perpendicular rectangle of height h that reaches from -left to right (Howell, A Catalog of
// Radiation Heat Transfer Configuration Factors, B-4, twice).
double hidden(double x, double h, double left, double right) {
    const double slant = std::hypot(x, h);
    const auto part = [&](double along) {
        return std::atan2(along, x) - x / slant * std::atan2(along, slant);
    };
    return (part(left) + part(right)) / (2 * std::numbers::pi);
}

// The walls stand where their first texels' centres lie: from texel 3.5 to 60.5 of 64.
double sky_seen(const glm::dvec2& texel) {
    constexpr double Low = 3.5, High = 60.5, Height = 26;
    const double west = texel.x - Low, east = High - texel.x;
    const double south = texel.y - Low, north = High - texel.y;
    return 1 - hidden(west, Height, south, north) - hidden(east, Height, south, north) -
           hidden(south, Height, west, east) - hidden(north, Height, west, east);
}

Oracle oracle() {
    return [image = gravel(64, 9)](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 1);
        const glm::dvec2 uv = (place.pixel - glm::dvec2(8, 20)) / glm::dvec2(144, 200);
        if (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return Color(0.1);
        const Color floor = place.panel == 0 ? Color(1) : bilinear(image, 2.0 * uv);
        return floor * sky_seen(4.5 + 55.0 * uv);
    };
}

} // namespace

Claim baked_occlusion_claim() {
    return {
        "T24",
        "colour = floor x visible; visible = mean over all directions phi of cos^2 horizon(phi) = "
        "1 - the four walls' form factors",
        oracle,
        1.0 / 8,
        5,
        0.8,
        "heights are looked at texel by texel, up to half a texel beside the direction: most "
        "where a wall is only a texel or two away",
        "the right floor is drawn without the second texture"};
}

} // namespace ffgpu::gallery
