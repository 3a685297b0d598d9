#include "tests/gallery/oracles/relief.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

template <class Value, class At>
Value between(const techniques::Field& field, const glm::dvec2& uv, const At& at) {
    const glm::dvec2 place = uv * glm::dvec2(field.width, field.height) - 0.5;
    const int x = static_cast<int>(std::floor(place.x)), y = static_cast<int>(std::floor(place.y));
    const double s = place.x - x, t = place.y - y;
    return (1 - s) * (1 - t) * at(x, y) + s * (1 - t) * at(x + 1, y) + (1 - s) * t * at(x, y + 1) +
           s * t * at(x + 1, y + 1);
}

} // namespace

double height_between(const techniques::Field& heights, const glm::dvec2& uv) {
    return between<double>(heights, uv, [&](int x, int y) { return heights.at(x, y); });
}

glm::dvec3 normal_between(const techniques::Field& heights, const glm::dvec2& uv, double scale) {
    return between<glm::dvec3>(heights, uv, [&](int x, int y) {
        const double right = heights.at(x + 1, y) - heights.at(x - 1, y);
        const double up = heights.at(x, y + 1) - heights.at(x, y - 1);
        return glm::normalize(glm::dvec3(-scale / 2 * right, -scale / 2 * up, 1));
    });
}

} // namespace ffgpu::gallery
