#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>

namespace ffgpu::gallery {
namespace {

struct Surface {
    int axis;
    double at;
    Color shade;
};
const std::array<Surface, 4> Room{{{2, 0, {0.3, 0.3, 0.33}},
                                   {1, 3, {0.4, 0.4, 0.43}},
                                   {0, -4, {0.22, 0.2, 0.2}},
                                   {0, 4, {0.2, 0.2, 0.22}}}};

bool in_room(const glm::dvec3& p) {
    constexpr double Slack = 1e-9;
    return std::abs(p.x) <= 4 + Slack && p.y >= -2 - Slack && p.y <= 3 + Slack && p.z >= -Slack &&
           p.z <= 3 + Slack;
}

Color lit(const Image& image, const glm::dvec3& point, const Color& shade) {
    static const Eye projector({0, 0.5, 1.4}, {4, 3.5, 1.2}, {0, 0, 1}, {56, 1});
    if (projector.in_frame(point - projector.position).z < 0) return shade; // q < 0: no light
    return clamped(shade + bilinear_bordered(image, projector.seen_at(point), Color(0)));
}

Oracle oracle() {
    return [image = slide(64)](const glm::dvec2& window) {
        static const Eye eye({0, -7, 2.2}, {0, 1, 1.2}, {0, 0, 1}, {45, 4.0 / 3});
        const glm::dvec3 ray = eye.ray(place_in(window, 1, 1).unit);
        double nearest_distance = HUGE_VAL;
        Color color(0);
        for (const Surface& surface : Room) {
            const double distance = (surface.at - eye.position[surface.axis]) / ray[surface.axis];
            if (distance <= 0 || distance >= nearest_distance) continue;
            const glm::dvec3 point = eye.position + distance * ray;
            if (!in_room(point)) continue;
            nearest_distance = distance;
            color = lit(image, point, surface.shade);
        }
        return color;
    };
}

} // namespace

Claim projective_texture_claim() {
    return {
        "T12",
        "(s, t, r, q) = B P_light V_light M p, B = scale and bias by 1/2; colour = surface + slide"
        "(s/q, t/q) where q > 0, the surface's own where q <= 0",
        oracle,
        1.0 / 8,
        1.5,
        0.4,
        "8 bits of weights and channels; the picture's coordinates are exact for each fragment",
        "no mask: the projector also throws its picture behind itself"};
}

} // namespace ffgpu::gallery
