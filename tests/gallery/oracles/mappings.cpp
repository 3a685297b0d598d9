#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

constexpr double Pi = std::numbers::pi;
const glm::dvec3 Egg(1.1, 0.6, 0.9);

struct Point {
    glm::dvec3 place, normal;
};

const Eye& eye() {
    static const Eye it({1.2, -4.2, 1.4}, {0, 0, 0}, {0, 0, 1}, {32, 106.0 / 80});
    return it;
}

std::optional<Point> surface(int panel, const glm::dvec3& ray) {
    if (panel == 4) {
        const auto hit = hit_cube(eye().position, ray, 0.8);
        if (!hit) return std::nullopt;
        const glm::dvec3 place = eye().position + hit->distance * ray;
        glm::dvec3 normal(0);
        normal[hit->axis] = place[hit->axis] > 0 ? 1 : -1;
        return Point{place, normal};
    }
    const glm::dvec3 radii = panel < 4 ? glm::dvec3(1) : Egg;
    const auto distance = hit_ellipsoid(eye().position, ray, radii);
    if (!distance) return std::nullopt;
    const glm::dvec3 place = eye().position + *distance * ray;
    const bool cut = std::abs(place.z) > 0.9 * std::sqrt(0.75); // the barrels have no lids
    if (panel > 5 && cut) return std::nullopt;
    return Point{place, glm::normalize(place / (radii * radii))};
}

// The seeds' spherical coordinates: theta from +z, phi around it.
glm::dvec2 around_sphere(const glm::dvec3& p) {
    return {(std::atan2(p.y, p.x) + Pi) / (2 * Pi), std::acos(p.z / glm::length(p)) / Pi};
}

// A cylinder of radius 1.5 around z, from -3 to 3.
glm::dvec2 around_cylinder(const glm::dvec3& from, const glm::dvec3& direction) {
    const double a = direction.x * direction.x + direction.y * direction.y;
    const double b = from.x * direction.x + from.y * direction.y;
    const double c = from.x * from.x + from.y * from.y - 1.5 * 1.5;
    const glm::dvec3 met = from + (std::sqrt(b * b - a * c) - b) / a * direction;
    return {(std::atan2(met.y, met.x) + Pi) / (2 * Pi), (met.z + 3) / 6};
}

// Sides of a cube of half size 0.8, u to the right of one who looks at it.
glm::dvec2 on_cube(const Point& point) {
    const glm::dvec3 p = point.place / 1.6 + 0.5, &n = point.normal;
    if (n.x != 0) return {n.x > 0 ? p.y : 1 - p.y, p.z};
    if (n.y != 0) return {n.y > 0 ? 1 - p.x : p.x, p.z};
    return {n.z > 0 ? p.x : 1 - p.x, p.y};
}

glm::dvec2 mapped(int panel, const Point& point) {
    const glm::dvec3& p = point.place;
    switch (panel) {
    case 0:
        return {0.5 * p.x + 0.1 * p.y + 0.5, 0.1 * p.y + 0.5 * p.z + 0.5};
    case 1:
        return glm::dvec2(p.x + 0.5 * p.y + 1.5, 0.5 * p.y + p.z + 1.5) / (p.y + 3);
    case 2:
        return {(std::atan2(p.y, p.x) + Pi) / (2 * Pi), (p.z + 1) / 2};
    case 3:
        return around_sphere(p);
    case 4:
        return on_cube(point);
    case 5:
        return around_sphere(point.normal);
    case 6:
        return around_cylinder(p, {p.x, p.y, 0});
    case 7:
        return around_cylinder(p, point.normal);
    default:
        return around_cylinder({0, 0, 0}, p);
    }
}

Oracle oracle() {
    return [image = waves(128)](const glm::dvec2& window) {
        const Place place = place_in(window, 3, 3);
        if (place.panel > 8 || place.unit.x > 1 || place.unit.y > 1) return Color(0.1);
        const auto point = surface(place.panel, eye().ray(place.unit));
        return point ? bilinear(image, mapped(place.panel, *point)) : Color(0.1);
    };
}

} // namespace

Claim mappings_claim() {
    return {
        "T10",
        "orthographic (u, v) = M_t p; perspective (u~/w, v~/w) = P_t p; cylinder u = (phi + pi) / "
        "2 pi, v = z; sphere v = acos(z/r) / pi; box: the side's own axes; proxies: by the "
        "cylinder's normal, the target's normal, the ray from the centre",
        oracle,
        1.0 / 8,
        40,
        0.7,
        "coordinates are linear between the vertices of a mesh of 96 x 48 cells; at a pole the "
        "turn runs "
        "through all values within one cell",
        "the cylinder's upper end is taken for 0.8 instead of 1"};
}

} // namespace ffgpu::gallery
