#include "tests/gallery/oracles/cube_faces.h"

#include "tests/gallery/oracles/space.h"

#include <cmath>

namespace ffgpu::gallery {

Color cube_lookup(const std::array<Image, 6>& faces, const glm::dvec3& d) {
    const glm::dvec3 size = glm::abs(d);
    glm::dvec2 st;
    double major = 0;
    std::size_t face = 0;
    if (size.x >= size.y && size.x >= size.z) {
        face = d.x >= 0 ? 0 : 1;
        st = {d.x >= 0 ? -d.z : d.z, -d.y};
        major = size.x;
    } else if (size.y >= size.z) {
        face = d.y >= 0 ? 2 : 3;
        st = {d.x, d.y >= 0 ? d.z : -d.z};
        major = size.y;
    } else {
        face = d.z >= 0 ? 4 : 5;
        st = {d.z >= 0 ? d.x : -d.x, -d.y};
        major = size.z;
    }
    return bilinear_clamped(faces[face], (st / major + 1.0) / 2.0);
}

} // namespace ffgpu::gallery
