#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

// The caster is a parallelogram: a corner and two edges.
const glm::dvec3 Corner(-0.9, -0.5, 1.1), Edge1(1.6, -0.2, -0.2), Edge2(0.2, 1.2, 0.2);
const Color Lit(0.8, 0.85, 0.7), Dark(0.18, 0.2, 0.3);

// Distance along the ray in its own lengths.
std::optional<double> hit_caster(const glm::dvec3& from, const glm::dvec3& ray) {
    const glm::dvec3 normal = glm::cross(Edge1, Edge2);
    const double distance = glm::dot(Corner - from, normal) / glm::dot(ray, normal);
    const glm::dvec3 at = from + distance * ray - Corner;
    const double square = glm::dot(normal, normal);
    const double a = glm::dot(glm::cross(at, Edge2), normal) / square;
    const double b = glm::dot(glm::cross(Edge1, at), normal) / square;
    if (distance <= 0 || a < 0 || a > 1 || b < 0 || b > 1) return std::nullopt;
    return distance;
}

const Eye& light() {
    static const Eye it({1.6, -1.2, 4}, {0, 0, 0}, {0, 0, 1}, {60, 1});
    return it;
}

// 1 if nothing stands between the light and the floor along the ray through the texel's centre.
double texel_lit(int x, int y) {
    const glm::dvec2 unit(std::clamp(x + 0.5, 0.5, 127.5) / 128,
                          std::clamp(y + 0.5, 0.5, 127.5) / 128);
    return hit_caster(light().position, light().ray(unit)) ? 0 : 1;
}

double lit_share(const glm::dvec3& point, bool filtered) {
    const glm::dvec2 at = light().seen_at(point) * 128.0;
    if (!filtered)
        return texel_lit(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
    const glm::dvec2 corner = glm::floor(at - 0.5), w = at - 0.5 - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    return (1 - w.y) * ((1 - w.x) * texel_lit(x, y) + w.x * texel_lit(x + 1, y)) +
           w.y * ((1 - w.x) * texel_lit(x, y + 1) + w.x * texel_lit(x + 1, y + 1));
}

Oracle oracle() {
    return [](const glm::dvec2& window) {
        static const Eye eye({0, -4.5, 4}, {-0.3, 0.2, 0.3}, {0, 0, 1}, {36, 160.0 / 240});
        const Place place = place_in(window, 2, 1);
        const glm::dvec3 ray = eye.ray(place.unit);
        if (hit_caster(eye.position, ray)) return Color(0.9, 0.5, 0.2);
        const glm::dvec3 point = eye.position - eye.position.z / ray.z * ray;
        if (ray.z >= 0 || std::abs(point.x) > 2.2 || std::abs(point.y) > 2.2) return Color(0.1);
        return glm::mix(Dark, Lit, lit_share(point, place.panel == 1));
    };
}

} // namespace

Claim shadow_map_claim() {
    return {"T18",
            "lit = mean over 4 texels, bilinear weights, of (depth of the fragment <= depth of the "
            "texel): compared first, filtered then",
            oracle,
            1.0 / 8,
            1,
            0.5,
            "weights of 8 bits; which texels the caster covers is exact",
            "the right panel takes the nearest texel, too"};
}

} // namespace ffgpu::gallery
