// Relief and occlusion against planes, spheres and walls whose answers are known.

#include "techniques/ambient_occlusion.h"
#include "techniques/relief.h"

#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace ffgpu::techniques {
namespace {

bool near(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) < 1e-12;
}

TEST_CASE("normals of a slope lean against it, and level ground is the map's blue") {
    Field slope(8, 8);
    for (int i = 0; i < 64; ++i)
        slope.at(i % 8, i / 8) = 2.0 * (i % 8) + 1.0 * (i / 8);
    CHECK(near(normal_of_height(slope, 3, 4, 0.5), glm::normalize(glm::dvec3(-1, -0.5, 1))));
    CHECK(encode_normal({0, 0, 1}) == std::array<std::uint8_t, 3>{128, 128, 255});
    CHECK(encode_normal({-1, 1, 0}) == std::array<std::uint8_t, 3>{0, 255, 128});
    const Texels level = normal_map(Field(2, 3), 1);
    CHECK(level.bytes.size() == 18);
    CHECK(level.bytes[17] == 255);
}

TEST_CASE("the normalisation cube map holds each direction with length 1") {
    // Table 3.19: on face +x, s runs towards -z and t towards -y.
    CHECK(near(cube_texel_direction(0, 4, 3, 0), {1, 0.75, -0.75}));
    CHECK(near(cube_texel_direction(2, 4, 0, 3), {-0.75, 1, 0.75}));
    CHECK(near(cube_texel_direction(5, 2, 0, 0), {0.5, 0.5, -1}));
    for (const Texels& face : normalisation_cube_map(16)) {
        for (std::size_t i = 0; i < face.bytes.size(); i += 3) {
            const glm::dvec3 n =
                glm::dvec3(face.bytes[i], face.bytes[i + 1], face.bytes[i + 2]) / 127.5 - 1.0;
            CHECK(std::abs(glm::length(n) - 1) < 0.008); // half a step in each of three components
        }
    }
}

TEST_CASE("a tangent frame is orthonormal, right-handed, and t runs where u grows") {
    const std::array<Corner, 3> triangle{
        {{{0, 0, 1}, {0, 0}}, {{0, 2, 1}, {1, 0}}, {{-3, 0, 1}, {0, 1}}}};
    const glm::dmat3 frame = tangent_frame(triangle, {0, 0, 4});
    CHECK(near(frame[0], {0, 1, 0}));
    CHECK(near(frame[1], {-1, 0, 0}));
    CHECK(near(frame[2], {0, 0, 1}));
    CHECK(glm::determinant(frame) == Approx(1));
    // Degenerate coordinates: some frame, still orthonormal.
    const std::array<Corner, 3> flat{
        {{{0, 0, 0}, {0, 0}}, {{1, 0, 0}, {0, 0}}, {{0, 1, 0}, {0, 0}}}};
    const glm::dmat3 any = tangent_frame(flat, {1, 2, 2});
    const glm::dmat3 unit = glm::transpose(any) * any;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            CHECK(unit[i][j] == Approx(i == j).margin(1e-12));
    }
}

TEST_CASE("displacement moves along the normal by the height under the coordinate") {
    Field heights(2, 1);
    heights.at(0, 0) = 1;
    heights.at(1, 0) = 3;
    CHECK(height_at(heights, {0.25, 0.5}) == Approx(1));
    CHECK(height_at(heights, {0.5, 0.5}) == Approx(2));
    CHECK(height_at(heights, {1.0, 0.5}) == Approx(2)); // half of the last, half of the first
    CHECK(near(displaced({{1, 1, 1}, {0.75, 0.5}}, {0, 1, 0}, heights, 0.5), {1, 2.5, 1}));
}

TEST_CASE("a lone needle on a diagonal hides by its own distance") {
    Field field(9, 9, 0);
    field.at(7, 7) = 3; // seen from (4, 4) at 45 degrees, the distance of 3 and 3 texels
    CHECK(ambient_occlusion(field, {4, 8}).at(4, 4) == Approx((3 + 1 / (1 + 9.0 / 18)) / 4));
}

TEST_CASE(
    "ambient occlusion: open ground sees all, a long wall hides (1 - x / sqrt(x^2 + h^2)) / 2") {
    const Field open = ambient_occlusion(Field(8, 8, 3), {});
    for (const double value : open.values)
        CHECK(value == 1);

    constexpr int Size = 401;
    constexpr double Height = 8;
    Field wall(61, Size, 0);
    for (int y = 0; y < Size; ++y)
        wall.at(60, y) = Height;
    const Field seen = ambient_occlusion(wall, {256, 400});
    for (const int distance : {4, 8, 20}) {
        const double x = distance;
        const double hidden = (1 - x / std::hypot(x, Height)) / 2;
        INFO(distance);
        CHECK(seen.at(60 - distance, Size / 2) == Approx(1 - hidden).margin(0.01));
    }
}

} // namespace
} // namespace ffgpu::techniques
