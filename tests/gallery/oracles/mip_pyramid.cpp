#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>

namespace ffgpu::gallery {
namespace {

// The mean of the side^2 texels of level 0 under one texel.
Color mean_of_square(const Image& image, int x, int y, int side) {
    Color sum(0);
    for (int i = 0; i < side * side; ++i)
        sum += texel(image, x * side + i % side, y * side + i / side);
    return sum / static_cast<double>(side * side);
}

Oracle oracle() {
    return [image = gravel(64, 3)](const glm::dvec2& window) {
        const Place place = place_in(window, 6, 2);
        const glm::dvec2 uv = (place.pixel - 2.0) / glm::dvec2(48, 116);
        if (window.x >= 6 * 53 || uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return Color(0.1);
        const int side = 1 << place.panel % 6, size = 64 / side;
        const glm::dvec2 index = glm::min(glm::floor(uv * static_cast<double>(size)), size - 1.0);
        return mean_of_square(image, static_cast<int>(index.x), static_cast<int>(index.y), side);
    };
}

} // namespace

Claim mip_pyramid_claim() {
    return {
        "T6",
        "level k + 1 at (x, y) = mean of the 4 texels of level k: the mean of 4^k texels of level "
        "0; storage 1 + 1/4 + 1/16 + ... < 4/3",
        oracle,
        1.0 / 8,
        2.6,
        0.8,
        "each level rounds to 8 bits, up to five times",
        "level 2 holds every fourth texel instead of means"};
}

} // namespace ffgpu::gallery
