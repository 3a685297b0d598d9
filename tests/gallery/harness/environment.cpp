#include "tests/gallery/harness/environment.h"

#include "techniques/relief.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

void set_color(Image& image, int x, int y, const glm::dvec3& color) {
    const glm::dvec3 byte = glm::round(255.0 * glm::clamp(color, 0.0, 1.0));
    image.set(x, y, static_cast<int>(byte.x), static_cast<int>(byte.y), static_cast<int>(byte.z));
}

double lamp(const glm::dvec3& direction, const glm::dvec3& towards, double sharpness) {
    return std::pow(std::max(0.0, glm::dot(direction, glm::normalize(towards))), sharpness);
}

} // namespace

glm::dvec3 environment(const glm::dvec3& towards) {
    const glm::dvec3 d = glm::normalize(towards);
    const glm::dvec3 sky = glm::mix(glm::dvec3(0.75, 0.8, 0.85), glm::dvec3(0.2, 0.35, 0.7), d.z);
    const double tiles = 0.5 + 0.5 * std::sin(7 * d.x) * std::sin(7 * d.y);
    const glm::dvec3 ground =
        glm::mix(glm::dvec3(0.35, 0.22, 0.1), glm::dvec3(0.6, 0.5, 0.3), tiles);
    const glm::dvec3 base = glm::mix(ground, sky, glm::smoothstep(-0.2, 0.2, d.z));
    const glm::dvec3 lamps = lamp(d, {1, -1, 1}, 40) * glm::dvec3(0.8, 0.6, 0.2) +
                             lamp(d, {-1, -0.3, 0.2}, 30) * glm::dvec3(0.6, 0.1, 0.4);
    return glm::clamp(0.85 * base + lamps, 0.0, 1.0);
}

std::array<Image, 6> environment_cube(int size) {
    std::array<Image, 6> faces{Image(size, size),
                               Image(size, size),
                               Image(size, size),
                               Image(size, size),
                               Image(size, size),
                               Image(size, size)};
    for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < size * size; ++i) {
            const glm::dvec3 towards =
                techniques::cube_texel_direction(face, size, i % size, i / size);
            set_color(
                faces[static_cast<std::size_t>(face)], i % size, i / size, environment(towards));
        }
    }
    return faces;
}

Image environment_sphere_map(int size) {
    Image image(size, size);
    for (int i = 0; i < size * size; ++i) {
        const double x = 2 * (i % size + 0.5) / size - 1;
        const double y = 2 * (i / size + 0.5) / size - 1;
        // The normal of the mirror ball in the picture; its rim, and what lies around it, sees -z.
        const double square = std::min(1.0, x * x + y * y);
        const glm::dvec3 normal(x, y, std::sqrt(1 - square));
        const glm::dvec3 reflected(2 * normal.z * x, 2 * normal.z * y, 2 * normal.z * normal.z - 1);
        set_color(image, i % size, i / size, environment(reflected));
    }
    return image;
}

} // namespace ffgpu::gallery
