#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>
#include <numbers>

namespace ffgpu::gallery {
namespace {

const std::array<Color, 3> BarColors{{{0.9, 0.25, 0.2}, {0.25, 0.75, 0.3}, {0.25, 0.4, 0.95}}};
// The painter's orders as the panels have them; the bar painted last counts.
const std::array<std::array<int, 3>, 6> Orders{
    {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};

// How near the bar is there, or nothing.
std::optional<double> bar_at(int bar, const glm::dvec2& at) {
    const double angle = -2 * std::numbers::pi / 3 * bar;
    const double x = std::cos(angle) * at.x - std::sin(angle) * at.y;
    const double y = std::sin(angle) * at.x + std::cos(angle) * at.y;
    if (x < 0.15 || x > 0.6 || std::abs(y) > 1.2) return std::nullopt;
    return y / 3;
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        const Place place = place_in(window, 4, 2);
        const glm::dvec2 at = (2.0 * place.unit - 1.0) * glm::dvec2(1.4, 1.4 * 1.5);
        Color color(0.95, 0.93, 0.88);
        double nearest_yet = -HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
            const bool painted = place.panel < 6;
            const int bar =
                painted ? Orders[static_cast<std::size_t>(place.panel)][i] : static_cast<int>(i);
            const auto near = bar_at(bar, at);
            if (!near || (!painted && *near < nearest_yet)) continue;
            nearest_yet = *near;
            color = BarColors[static_cast<std::size_t>(bar)];
        }
        return color;
    };
}

} // namespace

Claim painters_cycle_claim() {
    return {"T19",
            "z-buffer: the colour of the least z of all that cover the pixel; painter: of the last "
            "one painted",
            oracle,
            1.0 / 16,
            1,
            0.4,
            "coverage is exact up to the sub-pixel grid",
            "the depth test always passes"};
}

} // namespace ffgpu::gallery
