// Positions to window coordinates, normals, fog coordinates and point sizes, against the formulas
// of the specification in binary64.

#include "tests/geometry/scene.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

using Double4 = std::array<double, 4>;

Double4 multiply(const Mat4& m, const Double4& v) {
    Double4 result{};
    for (unsigned row = 0; row < 4; ++row)
        for (unsigned column = 0; column < 4; ++column)
            result[row] += double{m[4 * column + row]} * v[column];
    return result;
}

// A perspective with the eye at the origin, and a model some way down -z.
void set_perspective(Scene& scene) {
    scene.registers.transform.projection = {
        1.5f, 0, 0, 0, 0, 2, 0, 0, 0, 0, -1.02f, -1, 0, 0, -0.2f, 0};
    scene.registers.transform.model_view = {
        0.8f, 0.1f, 0.2f, 0, -0.2f, 0.9f, 0, 0, 0, 0.3f, 1.1f, 0, 0.1f, -0.2f, -4, 1};
}

TEST_CASE("window coordinates are GL's, on the grid of 1/256 pixel") {
    Random random(11);
    for (int round = 0; round < 200; ++round) {
        Scene scene;
        set_perspective(scene);
        scene.registers.viewport = {
            .x = 13, .y = 7, .width = 640, .height = 480, .near_depth = 0.25f, .far_depth = 0.75f};
        scene.registers.scissor = {.x = 0, .y = 0, .width = 653, .height = 487};
        const Double4 position{
            random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), 1};
        for (const double c : position)
            scene.words.push_back(static_cast<float>(c));
        const auto kept = scene.draw(PrimitiveType::Points);
        REQUIRE(kept.size() == 1);

        const Transform& transform = scene.registers.transform;
        const Double4 clip =
            multiply(transform.projection, multiply(transform.model_view, position));
        const double x = 13 + 320 * (clip[0] / clip[3] + 1), y = 7 + 240 * (clip[1] / clip[3] + 1);
        const double depth = 0.25 * (clip[2] / clip[3]) + 0.5;
        REQUIRE(std::fabs(kept[0][0].x - 256 * x) < 0.55);
        REQUIRE(std::fabs(kept[0][0].y - 256 * y) < 0.55);
        REQUIRE(std::fabs(kept[0][0].depth - depth) < 2e-7);
        REQUIRE(std::fabs(kept[0][0].inverse_w * clip[3] - 1) < 1e-6);
    }
}

TEST_CASE("a pixel-exact orthographic projection lands exactly on the pixel grid") {
    for (const unsigned size : {64u, 333u, 640u, 1000u, 1920u}) {
        Scene scene;
        const auto extent = static_cast<float>(size);
        scene.registers.viewport = {.width = extent, .height = extent};
        scene.registers.scissor = {.width = static_cast<std::uint16_t>(size),
                                   .height = static_cast<std::uint16_t>(size)};
        scene.registers.transform.projection = {
            2 / extent, 0, 0, 0, 0, 2 / extent, 0, 0, 0, 0, -1, 0, -1, -1, 0, 1};
        for (unsigned i = 1; i < size; ++i)
            scene.vertex({static_cast<float>(i), static_cast<float>(size - i), 0, 1});
        const auto kept = scene.draw(PrimitiveType::Points);
        REQUIRE(kept.size() == size - 1);
        for (unsigned i = 1; i < size; ++i) {
            REQUIRE(kept[i - 1][0].x == static_cast<int>(256 * i));
            REQUIRE(kept[i - 1][0].y == static_cast<int>(256 * (size - i)));
        }
    }
}

TEST_CASE("the near and the far plane have exactly the depths of the depth range") {
    Scene scene;
    scene.vertex({0, 0, -1, 1});
    scene.vertex({0, 0, 1, 1});
    auto kept = scene.draw(PrimitiveType::Points);
    CHECK(kept.at(0)[0].depth == 0);
    CHECK(kept.at(1)[0].depth == 1);
    std::swap(scene.registers.viewport.near_depth, scene.registers.viewport.far_depth);
    kept = scene.draw(PrimitiveType::Points);
    CHECK(kept.at(0)[0].depth == 1);
    CHECK(kept.at(1)[0].depth == 0);
}

// The normal is read back through texture generation.
Vec3 eye_normal(NormalMode mode, Vec3 normal, float rescale = 1) {
    Scene scene;
    scene.layout = {};
    scene.layout.tex_coord[0] = 0;
    scene.layout.tex_components[0] = 3;
    scene.layout.count = 3;
    scene.registers.tex_coords[0].mode = {
        TexGenMode::NormalMap, TexGenMode::NormalMap, TexGenMode::NormalMap, TexGenMode::Off};
    scene.registers.transform.normal_matrix = {2, 0, 0, 0, 0, -2, 0, 2, 0}; // a turn about x, twice
    scene.registers.transform.normal_mode = mode;
    scene.registers.transform.rescale = rescale;
    scene.carry(Attribute::Normal, 3);
    scene.vertex({0, 0, 0, 1, normal[0], normal[1], normal[2]});
    const auto attributes = scene.draw(PrimitiveType::Points).at(0)[0].attributes;
    return {attributes[0], attributes[1], attributes[2]};
}

TEST_CASE("normals are transformed, and kept, rescaled or normalised") {
    CHECK(eye_normal(NormalMode::Keep, {1, 2, 3}) == Vec3{2, -6, 4});
    CHECK(eye_normal(NormalMode::Rescale, {1, 2, 3}, 0.25f) == Vec3{0.5f, -1.5f, 1});
    CHECK(eye_normal(NormalMode::Normalize, {3, 0, 4}) == Vec3{0.6f, -0.8f, 0});
    CHECK(eye_normal(NormalMode::Normalize, {0, 0, 0}) == Vec3{0, 0, 0});
}

float fog_of(FogCoordinateSource source, std::initializer_list<float> position) {
    Scene scene;
    scene.layout = {};
    scene.layout.fog = 0;
    scene.layout.count = 1;
    scene.registers.fog.source = source;
    scene.carry(Attribute::FogCoordinate, 1);
    scene.vertex(position);
    scene.vertex({5});
    return scene.draw(PrimitiveType::Points).at(0)[0].attributes[0];
}

TEST_CASE("the fog coordinate comes from its source, after the division by w") {
    CHECK(fog_of(FogCoordinateSource::EyeZ, {0, 0, -0.5f, 1}) == 0.5f);
    CHECK(fog_of(FogCoordinateSource::EyeZ, {0, 0, -0.5f, 2}) == 0.25f);
    CHECK(fog_of(FogCoordinateSource::EyeZSigned, {0, 0, 0.5f, 1}) == 0.5f);
    CHECK(fog_of(FogCoordinateSource::EyeZSigned, {0, 0, -0.5f, 1}) == -0.5f);
    CHECK(fog_of(FogCoordinateSource::EyeRadial, {0.5f, 0.25f, 0.5f, 1}) == 0.75f);
    CHECK(fog_of(FogCoordinateSource::Attribute, {0, 0, -0.5f, 1}) == 5);
}

TEST_CASE("point sizes are attenuated with distance and clamped") {
    Scene scene;
    scene.registers.primitive.point_size = 8;
    scene.vertex({0, 0, 0, 1});
    scene.vertex({0.5f, 0.5f, -1, 1}); // The distance is that to the eye's plane.
    CHECK(scene.draw(PrimitiveType::Points).at(0)[0].point_size == 8);
    scene.registers.primitive.point_attenuation = {1, 1, 2};
    CHECK(scene.draw(PrimitiveType::Points).at(0)[0].point_size == 8);
    CHECK(scene.draw(PrimitiveType::Points).at(1)[0].point_size == 4);
    scene.registers.primitive.point_size_min = 5;
    scene.registers.primitive.point_size_max = 7;
    CHECK(scene.draw(PrimitiveType::Points).at(0)[0].point_size == 7);
    CHECK(scene.draw(PrimitiveType::Points).at(1)[0].point_size == 5);
}

TEST_CASE("a vertex that is not finite takes its primitives with it, and no others") {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(),
                            std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(),
                            1e30f}) {
        for (unsigned component = 0; component < 4; ++component) {
            Scene scene;
            for (const float x : {0.0f, 0.5f, 0.25f, 0.75f})
                scene.vertex({x, x * x, 0, 1});
            scene.words[component] = bad;
            CHECK(scene.draw(PrimitiveType::TriangleStrip).size() == 1);
            CHECK(scene.draw(PrimitiveType::Points).size() == 3);
            CHECK(scene.draw(PrimitiveType::LineLoop).size() == 2);
        }
    }
}

TEST_CASE("a viewport without area draws nothing") {
    Scene scene;
    scene.vertex({0, 0, 0, 1});
    scene.registers.viewport.width = 0;
    CHECK(scene.draw(PrimitiveType::Points).empty());
}

} // namespace
} // namespace ffgpu
