#include "techniques/relief.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace ffgpu::techniques {

std::array<std::uint8_t, 3> encode_normal(const glm::dvec3& normal) {
    return {to_byte((normal.x + 1) / 2), to_byte((normal.y + 1) / 2), to_byte((normal.z + 1) / 2)};
}

glm::dvec3 normal_of_height(const Field& heights, int x, int y, double scale) {
    const double du = (heights.at(x + 1, y) - heights.at(x - 1, y)) / 2;
    const double dv = (heights.at(x, y + 1) - heights.at(x, y - 1)) / 2;
    return glm::normalize(glm::dvec3(-scale * du, -scale * dv, 1));
}

Texels normal_map(const Field& heights, double scale) {
    Texels map{heights.width, heights.height, 1, 3, {}};
    for (int y = 0; y < heights.height; ++y) {
        for (int x = 0; x < heights.width; ++x) {
            const auto texel = encode_normal(normal_of_height(heights, x, y, scale));
            map.bytes.insert(map.bytes.end(), texel.begin(), texel.end());
        }
    }
    return map;
}

glm::dvec3 cube_texel_direction(int face, int size, int x, int y) {
    const double s = (2 * x + 1.0) / size - 1, t = (2 * y + 1.0) / size - 1;
    switch (face) {
    case 0:
        return {1, -t, -s};
    case 1:
        return {-1, -t, s};
    case 2:
        return {s, 1, t};
    case 3:
        return {s, -1, -t};
    case 4:
        return {s, -t, 1};
    default:
        return {-s, -t, -1};
    }
}

std::array<Texels, 6> normalisation_cube_map(int size) {
    std::array<Texels, 6> faces;
    for (int face = 0; face < 6; ++face) {
        Texels& map = faces[static_cast<std::size_t>(face)];
        map = {size, size, 1, 3, {}};
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const auto texel =
                    encode_normal(glm::normalize(cube_texel_direction(face, size, x, y)));
                map.bytes.insert(map.bytes.end(), texel.begin(), texel.end());
            }
        }
    }
    return faces;
}

glm::dmat3 tangent_frame(const glm::dvec3& p_u, const glm::dvec3& normal) {
    const glm::dvec3 m = glm::normalize(normal);
    glm::dvec3 along = p_u - glm::dot(p_u, m) * m;
    if (!(glm::dot(along, along) > 0)) // Any direction in the plane, from the axis least like m.
        along = glm::cross(m, std::abs(m.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
    const glm::dvec3 t = glm::normalize(along);
    return {t, glm::cross(m, t), m};
}

glm::dmat3 tangent_frame(const std::array<Corner, 3>& triangle, const glm::dvec3& normal) {
    const glm::dvec3 edge1 = triangle[1].position - triangle[0].position;
    const glm::dvec3 edge2 = triangle[2].position - triangle[0].position;
    const glm::dvec2 uv1 = triangle[1].uv - triangle[0].uv;
    const glm::dvec2 uv2 = triangle[2].uv - triangle[0].uv;
    const double area = uv1.x * uv2.y - uv2.x * uv1.y;
    if (area == 0) return tangent_frame(glm::dvec3(0), normal);
    return tangent_frame((uv2.y * edge1 - uv1.y * edge2) / area, normal);
}

double height_at(const Field& heights, const glm::dvec2& uv) {
    const glm::dvec2 texel = uv * glm::dvec2(heights.width, heights.height) - 0.5;
    const glm::dvec2 corner = glm::floor(texel);
    const glm::dvec2 weight = texel - corner;
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    const double lower = glm::mix(heights.at(x, y), heights.at(x + 1, y), weight.x);
    const double upper = glm::mix(heights.at(x, y + 1), heights.at(x + 1, y + 1), weight.x);
    return glm::mix(lower, upper, weight.y);
}

glm::dvec3
displaced(const Corner& corner, const glm::dvec3& normal, const Field& heights, double scale) {
    return corner.position + scale * height_at(heights, corner.uv) * normal;
}

} // namespace ffgpu::techniques
