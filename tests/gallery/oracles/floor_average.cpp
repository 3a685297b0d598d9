#include "tests/gallery/oracles/floor_average.h"

#include <cmath>

namespace ffgpu::gallery {

Eye grazing_eye(double aspect) {
    return {{0, 0, 1}, {0, 5, 0}, {0, 0, 1}, {19, aspect}};
}

std::optional<glm::dvec2> grazing_floor(const Eye& eye, const glm::dvec2& unit) {
    const glm::dvec3 ray = eye.ray(unit);
    if (ray.z >= 0) return std::nullopt;
    const glm::dvec2 point = glm::dvec2(ray) / -ray.z;
    if (point.y < 1 || point.y > 60 || std::abs(point.x) > 30) return std::nullopt;
    return point / 2.0;
}

Color area_average(const Image& image, const Eye& eye, const Place& place, int samples) {
    Color sum(0);
    for (int i = 0; i < samples * samples; ++i) {
        const glm::dvec2 within(i % samples + 0.5, static_cast<int>(i / samples) + 0.5);
        const glm::dvec2 pixel = place.pixel - 0.5 + within / static_cast<double>(samples);
        const auto uv = grazing_floor(eye, pixel / place.size);
        sum += uv ? nearest(image, *uv) : Color(0.45, 0.6, 0.8);
    }
    return sum / static_cast<double>(samples * samples);
}

} // namespace ffgpu::gallery
