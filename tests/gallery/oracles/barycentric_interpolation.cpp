#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace ffgpu::gallery {
namespace {

const std::array<glm::dvec2, 3> Places{{{15, 12}, {150, 40}, {60, 112}}};
// A column a corner.
const glm::dmat3 Colors({1, 0.1, 0}, {0, 0.9, 0.2}, {0.1, 0, 1});
const glm::dmat3 Coordinates({0, 0, 1}, {1, 0.2, 1}, {0.3, 1, 1});
const glm::dmat3 Normals({-0.8, -0.5, 0.4}, {0.9, 0, 0.5}, {0.1, 0.7, 0.9});
const glm::dvec3 Depths(-0.8, 0.5, 0.9);

Oracle oracle() {
    return [](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 2);
        const glm::dvec3 weights = barycentric(Places, place.pixel);
        const bool inside = weights.x >= 0 && weights.y >= 0 && weights.z >= 0;
        // glOrtho's near plane is +1 in front: window depth is (1 - z) / 2; the far plane is 1.
        if (place.panel == 3) return Color(inside ? (1 - glm::dot(weights, Depths)) / 2 : 1.0);
        if (!inside) return Color(0.1);
        if (place.panel == 0) return Colors * weights;
        if (place.panel == 2) return (glm::normalize(Normals * weights) + 1.0) / 2.0;
        // Coordinates by the matrix M_t M_s^-1 of homogeneous corners, from screen to texture.
        const glm::dmat3 screen(glm::dvec3(Places[0], 1), {Places[1], 1}, {Places[2], 1});
        const glm::dvec3 uv = Coordinates * glm::inverse(screen) * glm::dvec3(place.pixel, 1);
        const glm::dvec2 texels = glm::clamp(256.0 * glm::dvec2(uv) - 0.5, 0.0, 255.0);
        return Color(texels / 255.0, 128.0 / 255);
    };
}

} // namespace

Claim barycentric_interpolation_claim() {
    return {"T3",
            "value = alpha V_A + beta V_B + gamma V_C, alpha = area(P, B, C) / area(A, B, C); "
            "(u, v, 1) = M_uv M_xy^-1 (x, y, 1)",
            oracle,
            1.0 / 16,
            1.5,
            0.5,
            "8 bits of the interpolated channels; the normalisation map has 128^2 texels a face",
            "flat shading: the last corner's colour everywhere"};
}

} // namespace ffgpu::gallery
