#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/floor_average.h"

namespace ffgpu::gallery {
namespace {

Oracle oracle() {
    return [image = checker(64, 4), eye = grazing_eye(4.0 / 3)](const glm::dvec2& window) {
        return area_average(image, eye, place_in(window, 1, 1), 16);
    };
}

} // namespace

Claim supersampling_claim() {
    return {
        "T9",
        "colour = mean over the pixel's square, here of a grid of 4 x 4 points; the oracle takes "
        "16 x 16",
        oracle,
        0,
        80,
        6,
        "16 points instead of 256: a square's edge is seen in steps of 1/16",
        "all 16 pictures through the pixels' centres"};
}

} // namespace ffgpu::gallery
