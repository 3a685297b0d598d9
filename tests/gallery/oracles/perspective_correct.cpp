#include "tests/gallery/oracles/claims.h"
#include "tests/gallery/oracles/space.h"

#include <cmath>
#include <optional>

namespace ffgpu::gallery {
namespace {

const Color Sky(0.45, 0.6, 0.8);
const glm::dvec2 Shift(0, 0.3); // of the lens, in heights of the panel

struct ScreenTriangle {
    std::array<glm::dvec2, 3> places; // [0, 1]^2 of the panel
    std::array<glm::dvec2, 3> uv;
};

const Eye& eye() {
    static const Eye it({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, {45, 160.0 / 120});
    return it;
}

void add_cells(std::vector<ScreenTriangle>& all, glm::dvec2 x, int columns, int rows) {
    const auto vertex = [&](int column, int row) {
        const double px = x[0] + (x[1] - x[0]) * column / columns;
        const double pz = 1.6 + 7.4 * row / rows;
        return std::pair{eye().seen_at({px, -1, -pz}) + Shift,
                         glm::dvec2((px + 2) / 4, static_cast<double>(row) / rows)};
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const auto a = vertex(column, row), b = vertex(column + 1, row);
            const auto c = vertex(column + 1, row + 1), d = vertex(column, row + 1);
            all.push_back({{a.first, b.first, c.first}, {a.second, b.second, c.second}});
            all.push_back({{a.first, c.first, d.first}, {a.second, c.second, d.second}});
        }
    }
}

// Linear in screen space within the triangle that holds the point.
std::optional<glm::dvec2> affine(const std::vector<ScreenTriangle>& all, const glm::dvec2& at) {
    for (const ScreenTriangle& triangle : all) {
        const glm::dvec3 w = barycentric(triangle.places, at);
        if (w.x < 0 || w.y < 0 || w.z < 0) continue;
        return w.x * triangle.uv[0] + w.y * triangle.uv[1] + w.z * triangle.uv[2];
    }
    return std::nullopt;
}

// Where the ray meets the floor.
std::optional<glm::dvec2> in_space(const glm::dvec2& at) {
    const glm::dvec3 ray = eye().ray(at - Shift);
    if (ray.y >= 0) return std::nullopt;
    const glm::dvec3 point = ray * (-1 / ray.y);
    const glm::dvec2 uv((point.x + 2) / 4, (-point.z - 1.6) / 7.4);
    if (uv.x < 0 || uv.x > 1 || uv.y < 0 || uv.y > 1) return std::nullopt;
    return uv;
}

Oracle oracle() {
    std::array<std::vector<ScreenTriangle>, 4> meshes;
    add_cells(meshes[1], {-2, 2}, 1, 1);
    add_cells(meshes[2], {-2, 2}, 6, 6);
    add_cells(meshes[3], {-2, 0}, 1, 2);
    add_cells(meshes[3], {0, 2}, 3, 6);
    return [image = checker(8, 8), meshes](const glm::dvec2& window) {
        const Place place = place_in(window, 2, 2);
        const auto panel = static_cast<std::size_t>(place.panel);
        const auto uv = panel == 0 ? in_space(place.unit) : affine(meshes[panel], place.unit);
        return uv ? nearest(image, *uv) : Sky;
    };
}

} // namespace

Claim perspective_correct_claim() {
    return {"T4",
            "perspective: u = (sum a_i u_i / w_i) / (sum a_i / w_i); affine: u = sum a_i u_i, "
            "a_i the screen's barycentric weights",
            oracle,
            1.0 / 8,
            1,
            0.2,
            "which square it is has one answer, up to 1/8 pixel of its border",
            "the first panel is affine, too"};
}

} // namespace ffgpu::gallery
