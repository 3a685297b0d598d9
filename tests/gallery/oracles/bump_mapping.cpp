#include "tests/gallery/harness/heights.h"
#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/relief.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

Oracle oracle() {
    return [heights = hills(128)](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 1);
        const glm::dvec2 uv = (place.pixel - 5.0) / glm::dvec2(150, 230);
        if (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return Color(0.1);
        double value = 0;
        if (place.panel == 0)
            value = glm::dot(normal_between(heights, uv, 20), glm::dvec3(-0.6, 0, 0.8));
        else
            value = 0.5 + height_between(heights, uv) -
                    height_between(heights, uv - glm::dvec2(0.04, 0));
        return Color(std::clamp(value, 0.0, 1.0));
    };
}

} // namespace

Claim bump_mapping_claim() {
    return {
        "T16",
        "n = (-c dh/du, -c dh/dv, 1) / |.|, colour = max(n . l, 0); emboss: 1/2 + h(u, v) - h(u + "
        "du, v)",
        oracle,
        1.0 / 8,
        5,
        0.7,
        "normals and light of 8 bits a component: 1/127 each; heights of 8 bits",
        "the heights' scale is negative"};
}

} // namespace ffgpu::gallery
