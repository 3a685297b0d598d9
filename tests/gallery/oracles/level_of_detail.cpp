#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

const Color Sky(0.45, 0.6, 0.8);

Color level_color(int level) {
    static const std::array<Color, 8> colors{{{230, 60, 50},
                                              {240, 200, 40},
                                              {60, 190, 70},
                                              {50, 200, 220},
                                              {60, 70, 220},
                                              {200, 60, 210},
                                              {240, 240, 240},
                                              {20, 20, 20}}};
    return colors[static_cast<std::size_t>(std::clamp(level, 0, 7))] / 255.0;
}

// Where the floor z = 0 is seen, in texels of level 0.
std::optional<glm::dvec2> texels_at(const glm::dvec2& unit) {
    static const Eye eye({0, 0, 1}, {0.5, 4, 0}, {0, 0, 1}, {60, 160.0 / 240});
    const glm::dvec3 ray = eye.ray(unit);
    if (ray.z >= 0) return std::nullopt;
    const glm::dvec3 point = eye.position - eye.position.z / ray.z * ray;
    if (point.y < 0.2 || point.y > 40 || std::abs(point.x) > 20) return std::nullopt;
    return 128.0 * glm::dvec2(point);
}

Color floor_color(int panel, double level) {
    if (level <= 0) return level_color(0);
    if (panel == 0) return level_color(static_cast<int>(std::ceil(level + 0.5)) - 1);
    const int finer = static_cast<int>(std::floor(level));
    const double weight = level - finer;
    return (1 - weight) * level_color(finer) + weight * level_color(finer + 1);
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 1);
        const auto here = texels_at(place.unit);
        if (!here) return Sky;
        // Derivatives by a small step; at the floor's far edge a step may leave it.
        constexpr double Step = 1e-4;
        const auto right = texels_at((place.pixel + glm::dvec2(Step, 0)) / place.size);
        const auto up = texels_at((place.pixel + glm::dvec2(0, Step)) / place.size);
        if (!right || !up) return Sky;
        const double longest =
            std::max(glm::length(*right - *here), glm::length(*up - *here)) / Step;
        return floor_color(place.panel, std::log2(longest));
    };
}

} // namespace

Claim level_of_detail_claim() {
    return {
        "T7",
        "L = max(sqrt((du/dx)^2 + (dv/dx)^2), sqrt((du/dy)^2 + (dv/dy)^2)), D = log2 L; nearest: "
        "level ceil(D + 1/2) - 1; trilinear: (1 - f) c[floor D] + f c[floor D + 1], f = D - floor "
        "D",
        oracle,
        1.25,
        3,
        0.4,
        "one level for each quad of 2 x 2 pixels, by differences of neighbours instead of "
        "derivatives (a pixel of reach); log2 with 8 fraction bits",
        "the level is biased by 1/2"};
}

} // namespace ffgpu::gallery
