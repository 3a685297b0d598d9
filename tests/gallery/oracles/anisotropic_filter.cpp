#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/floor_average.h"

namespace ffgpu::gallery {
namespace {

Oracle oracle() {
    return [image = gravel(256, 5), eye = grazing_eye(320.0 / 80)](const glm::dvec2& window) {
        return area_average(image, eye, place_in(window, 1, 3), 16);
    };
}

} // namespace

Claim anisotropic_filter_claim() {
    return {
        "T8",
        "colour = mean of the texture over the pixel's footprint; the hardware takes N = ceil"
        "(longer / shorter) probes along the longer axis, each of level log2(longer / N)",
        oracle,
        0,
        90,
        9,
        "all three strips against the same area average of 16 x 16 points: the upper one is too "
        "soft, and a probe's weight is not a box's",
        "one probe everywhere: three times trilinear"};
}

} // namespace ffgpu::gallery
