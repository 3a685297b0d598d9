#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/floor_average.h"

namespace ffgpu::gallery {
namespace {

Oracle oracle() {
    return [image = gravel(256, 5), eye = grazing_eye(4.0 / 3)](const glm::dvec2& window) {
        return area_average(image, eye, place_in(window, 1, 1), 16);
    };
}

} // namespace

Claim filter_strip_claim() {
    return {"F",
            "the mean of 16 x 16 points of each pixel's area",
            oracle,
            0,
            255,
            255,
            "how far a filter is from the mean is what is measured",
            "none"};
}

} // namespace ffgpu::gallery
