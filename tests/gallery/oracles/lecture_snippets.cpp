#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

namespace ffgpu::gallery {
namespace {

Oracle oracle() {
    return [image = chart(64)](const glm::dvec2& window) {
        static const Eye eye({5, -8, 42}, {0, 4.5, 0}, {0, 1, 0}, {60, 106.0 / 240});
        static const Eye projector({0, -4, 12}, {0, 3, 0}, {0, 1, 0}, {50, 1});
        const Color background(0.1, 0.15, 0.2);
        const Place place = place_in(window, 3, 1);
        if (window.x >= 318) return background;
        const glm::dvec3 ray = eye.ray(place.unit);
        const glm::dvec3 point = eye.position - eye.position.z / ray.z * ray;
        const glm::dvec3 w = barycentric({{{-10, 0}, {10, 0}, {5, 10}}}, glm::dvec2(point));
        if (ray.z >= 0 || w.x < 0 || w.y < 0 || w.z < 0) return background;
        if (place.panel == 0) return Color(1); // an incomplete texture is none
        if (place.panel == 1) return bilinear(image, {w.y + 0.5 * w.z, w.z});
        return bilinear(image, projector.seen_at(point + glm::dvec3(1.5, 0, 0)));
    };
}

} // namespace

Claim lecture_snippets_claim() {
    return {"T25",
            "[u, v] = a_0 [u_0, v_0] + a_1 [u_1, v_1] + a_2 [u_2, v_2]; [s, t, r, q] = T(1/2) "
            "S(1/2) P V M "
            "[x, y, z, 1]",
            oracle,
            1.0 / 8,
            1.5,
            0.4,
            "weights of 8 bits",
            "the texture matrix without its scale by 1/2"};
}

} // namespace ffgpu::gallery
