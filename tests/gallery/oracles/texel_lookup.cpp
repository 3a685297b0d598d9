#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>

namespace ffgpu::gallery {
namespace {

Oracle oracle() {
    return [image = random_colours(8, 1)](const glm::dvec2& window) {
        // The parallelogram's corner and edges, solved for (u, v).
        const glm::dvec2 at = window - glm::dvec2(30, 20), e1(270, 20), e2(-20, 190);
        const double area = e1.x * e2.y - e1.y * e2.x;
        const double u = (at.x * e2.y - at.y * e2.x) / area;
        const double v = (e1.x * at.y - e1.y * at.x) / area;
        if (u < 0 || u > 1 || v < 0 || v > 1) return Color(0.1);
        const int i = static_cast<int>(std::lround(u * 8 - 0.5));
        const int j = static_cast<int>(std::lround(v * 8 - 0.5));
        return texel(image, i, j);
    };
}

} // namespace

Claim texel_lookup_claim() {
    return {"T1",
            "i = round(u w - 1/2), j = round(v h - 1/2)",
            oracle,
            1.0 / 8,
            1,
            0.4,
            "which texel it is has one answer, up to the texel coordinate's 8 fraction bits (1/8 "
            "pixel)",
            "coordinates begin at 0.5 / w: half a texel too far"};
}

} // namespace ffgpu::gallery
