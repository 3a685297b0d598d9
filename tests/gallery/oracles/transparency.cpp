#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <vector>

namespace ffgpu::gallery {
namespace {

struct Layer {
    double depth, alpha;
    Color color;
};
struct Pane {
    double left, bottom, right, top;
    Layer layer;
};
const std::array<Pane, 4> Panes{{{20, 40, 100, 110, {0.6, 0.5, {0.9, 0.2, 0.2}}},
                                 {60, 10, 140, 80, {0.3, 0.6, {0.2, 0.8, 0.3}}},
                                 {40, 25, 120, 95, {0.8, 0.7, {0.2, 0.4, 1.0}}},
                                 {10, 55, 150, 75, {0.45, 0.4, {1.0, 0.9, 0.2}}}}};
const Pane Opaque{75, 5, 95, 115, {0.5, 1, {0.15, 0.15, 0.15}}};

std::optional<Layer> layer_of(const Pane& pane, const glm::dvec2& at) {
    if (at.x < pane.left || at.x > pane.right || at.y < pane.bottom || at.y > pane.top)
        return std::nullopt;
    Layer layer = pane.layer;
    layer.depth += 0.05 * (at.x - pane.left) / (pane.right - pane.left);
    return layer;
}

// The pixel's alpha buffer: a list of depth, alpha and colour, in order of submission.
std::vector<Layer> layers_at(const glm::dvec2& at, const std::array<int, 4>& order) {
    std::vector<Layer> layers;
    const auto opaque = layer_of(Opaque, at);
    for (const int i : order) {
        const auto layer = layer_of(Panes[static_cast<std::size_t>(i)], at);
        if (layer && (!opaque || layer->depth < opaque->depth)) layers.push_back(*layer);
    }
    return layers;
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 2);
        const bool reversed = place.panel == 1;
        std::vector<Layer> layers =
            layers_at(place.pixel, reversed ? std::array{3, 2, 1, 0} : std::array{0, 1, 2, 3});
        if (place.panel > 1) { // from the farthest to the nearest
            std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) {
                return a.depth > b.depth;
            });
        }
        const auto opaque = layer_of(Opaque, place.pixel);
        Color color = opaque ? opaque->color : Color(0.95, 0.93, 0.88);
        for (const Layer& layer : layers)
            color = layer.alpha * layer.color + (1 - layer.alpha) * color;
        return color;
    };
}

} // namespace

Claim transparency_claim() {
    return {
        "T20",
        "C = a_1 c_1 + (1 - a_1)(a_2 c_2 + (1 - a_2)( ... )), layer 1 the nearest; submitted in "
        "another order it is another colour",
        oracle,
        1.0 / 16,
        2.5,
        0.5,
        "each blend rounds to 8 bits, up to five times",
        "one layer is peeled instead of five"};
}

} // namespace ffgpu::gallery
