// Texture coordinates: the five generation modes, matrices, what is carried.

#include "tests/geometry/scene.h"

#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

constexpr unsigned Unit = 2;

struct TexScene : Scene {
    TexScene() {
        layout = {};
        layout.tex_coord[Unit] = 0;
        layout.tex_components[Unit] = 4;
        layout.count = 4;
        carry(Attribute::Normal, 3);
        carry(tex_coord(Unit), 4);
        vertex({0.5f, 0.25f, -0.5f, 1, 0, 0.6f, 0.8f, 1, 2, 3, 4});
    }

    TexCoordSetup& setup() { return registers.tex_coords[Unit]; }
    void set_mode(TexGenMode mode) { setup().mode = {mode, mode, mode, mode}; }
    Vec4 coordinates() {
        const auto kept = draw(PrimitiveType::Points);
        REQUIRE(kept.size() == 1);
        Vec4 result{};
        std::copy_n(kept[0][0].attributes.begin(), layout.count, result.begin());
        return result;
    }
};

TEST_CASE("without generation and matrix coordinates pass as they are") {
    TexScene scene;
    CHECK(scene.coordinates() == Vec4{1, 2, 3, 4});
    scene.layout.tex_components[Unit] = 2;
    scene.layout.count = 2;
    CHECK(scene.coordinates() == Vec4{1, 2, 0, 0});
}

TEST_CASE("object-linear generation is the plane times the object position, each its own") {
    TexScene scene;
    scene.registers.transform.model_view[12] = 0.125f; // Does not matter here.
    scene.setup().mode = {
        TexGenMode::ObjectLinear, TexGenMode::Off, TexGenMode::ObjectLinear, TexGenMode::Off};
    scene.setup().plane = {{{1, 0, 0, 0}, {9, 9, 9, 9}, {2, 4, 8, 16}, {9, 9, 9, 9}}};
    CHECK(scene.coordinates() == Vec4{0.5f, 2, 14, 4});
}

TEST_CASE("eye-linear generation is the plane times the eye position") {
    TexScene scene;
    scene.registers.transform.model_view[12] = 0.125f;
    scene.set_mode(TexGenMode::EyeLinear);
    scene.setup().plane = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 1, 1, 1}}};
    CHECK(scene.coordinates() == Vec4{0.625f, 0.25f, -0.5f, 1.375f});
}

TEST_CASE("sphere, normal and reflection maps follow their formulas") {
    TexScene scene;
    const double length = std::sqrt(0.5 * 0.5 + 0.25 * 0.25 + 0.5 * 0.5);
    const std::array<double, 3> u{0.5 / length, 0.25 / length, -0.5 / length}, n{0, 0.6, 0.8};
    const double n_dot_u = n[1] * u[1] + n[2] * u[2];
    std::array<double, 3> r;
    for (unsigned i = 0; i < 3; ++i)
        r[i] = u[i] - 2 * n[i] * n_dot_u;

    scene.set_mode(TexGenMode::ReflectionMap);
    Vec4 generated = scene.coordinates();
    for (unsigned i = 0; i < 3; ++i)
        CHECK(std::fabs(generated[i] - r[i]) < 1e-6);

    scene.set_mode(TexGenMode::NormalMap);
    generated = scene.coordinates();
    for (unsigned i = 0; i < 3; ++i)
        CHECK(std::fabs(generated[i] - n[i]) < 1e-6);

    scene.set_mode(TexGenMode::SphereMap);
    generated = scene.coordinates();
    const double m = 2 * std::sqrt(r[0] * r[0] + r[1] * r[1] + (r[2] + 1) * (r[2] + 1));
    for (unsigned i = 0; i < 2; ++i)
        CHECK(std::fabs(generated[i] - (r[i] / m + 0.5)) < 1e-6);
}

TEST_CASE("the texture matrix follows generation and may fill a component from another") {
    TexScene scene;
    scene.setup().matrix = {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.5f, 0, 0, 1};
    CHECK(scene.coordinates() == Vec4{1, 2, 3, 4}); // Disabled.
    scene.setup().matrix_enable = true;
    CHECK(scene.coordinates() == Vec4{4, 2, 3, 4});
    scene.setup().mode[0] = TexGenMode::ObjectLinear;
    scene.setup().plane[0] = {0, 0, 0, 10};
    CHECK(scene.coordinates() == Vec4{22, 2, 3, 4});
    scene.layout.tex_components[Unit] = 2;
    scene.layout.count = 2;
    CHECK(scene.coordinates() == Vec4{22, 2, 0, 0});
}

} // namespace
} // namespace ffgpu
