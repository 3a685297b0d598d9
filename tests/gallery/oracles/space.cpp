#include "tests/gallery/oracles/space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
}

// Between the four texels around (x, y), coordinates of texel centres.
template <class Texel>
Color blend_texels(const glm::dvec2& at, const Texel& texel_at) {
    const glm::dvec2 corner = glm::floor(at), weight = at - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    const Color lower = texel_at(x, y) + weight.x * (texel_at(x + 1, y) - texel_at(x, y));
    const Color upper =
        texel_at(x, y + 1) + weight.x * (texel_at(x + 1, y + 1) - texel_at(x, y + 1));
    return lower + weight.y * (upper - lower);
}

glm::dvec2 in_texels(const Image& image, const glm::dvec2& uv) {
    return uv * glm::dvec2(image.width, image.height) - 0.5;
}

} // namespace

Place place_in(const glm::dvec2& window, int columns, int rows) {
    const glm::dvec2 size(WindowWidth / columns, WindowHeight / rows);
    const int column = std::min(static_cast<int>(window.x / size.x), columns - 1);
    const int from_below = std::min(static_cast<int>(window.y / size.y), rows - 1);
    const glm::dvec2 pixel = window - glm::dvec2(column, from_below) * size;
    return {(rows - 1 - from_below) * columns + column, pixel / size, pixel, size};
}

Eye::Eye(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& upwards, glm::dvec2 field)
    : position(from)
    , forward(glm::normalize(to - from))
    , right(glm::normalize(glm::cross(forward, upwards)))
    , up(glm::cross(right, forward))
    , tangent(std::tan(field.x * std::numbers::pi / 360))
    , aspect(field.y) {}

glm::dvec3 Eye::ray(const glm::dvec2& unit) const {
    const glm::dvec2 screen = 2.0 * unit - 1.0;
    return forward + tangent * (screen.x * aspect * right + screen.y * up);
}

glm::dvec3 Eye::in_frame(const glm::dvec3& direction) const {
    return {glm::dot(direction, right), glm::dot(direction, up), glm::dot(direction, forward)};
}

glm::dvec2 Eye::seen_at(const glm::dvec3& point) const {
    const glm::dvec3 local = in_frame(point - position);
    return glm::dvec2(local.x / aspect, local.y) / (local.z * tangent) * 0.5 + 0.5;
}

std::optional<double>
hit_ellipsoid(const glm::dvec3& from, const glm::dvec3& direction, const glm::dvec3& radii) {
    const glm::dvec3 origin = from / radii, along = direction / radii;
    const double a = glm::dot(along, along), b = glm::dot(origin, along);
    const double root = b * b - a * (glm::dot(origin, origin) - 1);
    if (root < 0) return std::nullopt;
    const double distance = (-b - std::sqrt(root)) / a;
    return distance > 0 ? std::optional(distance) : std::nullopt;
}

std::optional<BoxHit> hit_cube(const glm::dvec3& from, const glm::dvec3& direction, double half) {
    double enter = -HUGE_VAL, leave = HUGE_VAL;
    int axis = 0;
    for (int i = 0; i < 3; ++i) {
        const double one = (-half - from[i]) / direction[i];
        const double two = (half - from[i]) / direction[i];
        if (std::min(one, two) > enter) {
            enter = std::min(one, two);
            axis = i;
        }
        leave = std::min(leave, std::max(one, two));
    }
    if (enter >= leave || enter <= 0) return std::nullopt;
    return BoxHit{enter, axis};
}

Color texel(const Image& image, int x, int y) {
    const int column = (x % image.width + image.width) % image.width;
    const int row = (y % image.height + image.height) % image.height;
    const std::uint8_t* const rgba = image.texel(column, row);
    return Color(rgba[0], rgba[1], rgba[2]) / 255.0;
}

Color nearest(const Image& image, const glm::dvec2& uv) {
    const glm::dvec2 index = glm::floor(uv * glm::dvec2(image.width, image.height));
    return texel(image, static_cast<int>(index.x), static_cast<int>(index.y));
}

Color bilinear(const Image& image, const glm::dvec2& uv) {
    return blend_texels(in_texels(image, uv), [&](int x, int y) { return texel(image, x, y); });
}

Color bilinear_clamped(const Image& image, const glm::dvec2& uv) {
    return blend_texels(in_texels(image, uv), [&](int x, int y) {
        return texel(image, std::clamp(x, 0, image.width - 1), std::clamp(y, 0, image.height - 1));
    });
}

Color bilinear_bordered(const Image& image, const glm::dvec2& uv, const Color& border) {
    return blend_texels(in_texels(image, uv), [&](int x, int y) {
        const bool inside = x >= 0 && y >= 0 && x < image.width && y < image.height;
        return inside ? texel(image, x, y) : border;
    });
}

glm::dvec3 barycentric(const std::array<glm::dvec2, 3>& corners, const glm::dvec2& point) {
    const double whole = area(corners[0], corners[1], corners[2]);
    return glm::dvec3(area(point, corners[1], corners[2]),
                      area(corners[0], point, corners[2]),
                      area(corners[0], corners[1], point)) /
           whole;
}

} // namespace ffgpu::gallery
