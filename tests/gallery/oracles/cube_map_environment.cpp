#include "tests/gallery/harness/environment.h"
#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <glm/geometric.hpp>

namespace ffgpu::gallery {
namespace {

// The surroundings' own formula instead of their six pictures: a face that is turned or mirrored
// would show.
Oracle oracle() {
    return [](const glm::dvec2& window) {
        static const Eye eye({2.2, -3.2, 1.2}, {0, 0, 0}, {0, 0, 1}, {40, 4.0 / 3});
        const glm::dvec3 ray = glm::normalize(eye.ray(place_in(window, 1, 1).unit));
        const auto distance = hit_ellipsoid(eye.position, ray, glm::dvec3(1));
        if (!distance) return environment(ray);
        const glm::dvec3 normal = eye.position + *distance * ray;
        return environment(ray - 2 * glm::dot(ray, normal) * normal);
    };
}

} // namespace

Claim cube_map_environment_claim() {
    return {
        "T13",
        "r = i - 2 (n . i) n; the face of r's largest component, s = (sc / |ma| + 1) / 2, t = (tc "
        "/ "
        "|ma| + 1) / 2",
        oracle,
        1.0 / 8,
        3,
        0.5,
        "faces of 128^2 texels of 8 bits; reflections are linear between the vertices of 128 x 64 "
        "cells, which bend most at the rim",
        "reflections stay in the eye's frame"};
}

} // namespace ffgpu::gallery
