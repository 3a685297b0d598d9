// What the stage probe tells of planes that not every draw has: four texture coordinates, a batch
// with and without perspective, a cube map at the edge of a face.

#include "tests/gpu/pixel_probe.h"
#include "tests/gpu/scene.h"

#include <algorithm>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::test;

namespace {

const auto Coordinate = static_cast<unsigned>(Attribute::TexCoord0);

// From column `left` to column `right` of 16, over the whole height, w = 1. s t r q are `from` at
// the left and `to` at the right; they stand where colours do.
std::vector<Vertex> columns(float left, float right, const float (&from)[4], const float (&to)[4]) {
    std::vector<Vertex> vertices;
    for (const bool at_right : {false, true, true, false}) {
        const float x = (at_right ? right : left) / 8 - 1;
        const float y = vertices.size() < 2 ? -1.0f : 1.0f;
        const float(&c)[4] = at_right ? to : from;
        vertices.push_back({x, y, 0, 1, c[0], c[1], c[2], c[3], 0, 0});
    }
    return vertices;
}

} // namespace

TEST_CASE("the probe tells as many texture coordinates as the planes carry") {
    for (const unsigned count : {2u, 3u, 4u}) {
        Scene scene(16, 16);
        scene.clear(0);
        scene.texture(2, {1, 2, 3, 4});
        scene.registers.vertex_format.elements[Coordinate] = {static_cast<std::uint8_t>(count), 4};
        if (count == 3) scene.registers.images[0].shape.kind = TextureKind::ThreeD;
        PixelProbe told(9, 5);
        scene.gpu.set_stage_probe(&told);
        scene.draw(PrimitiveType::Quads, columns(0, 16, {0, 1, 2, 2}, {16, 1, -14, 4}));
        scene.gpu.finish();
        INFO(count << " coordinates");
        CHECK(told.carried == count);
        // x = 9.5 of 16, w = 1.
        const double all[] = {9.5, 1, 2 - 9.5, 2 + 9.5 / 8};
        for (unsigned i = 0; i < count; ++i)
            CHECK(told.tex_coord_over_w[i] == Approx(all[i]));
        CHECK(told.s == Approx(count == 4 ? all[0] / all[3] : all[0]));
    }
}

TEST_CASE("the probe tells 1 for 1/w of a primitive without perspective beside one with it") {
    Scene scene(16, 16);
    scene.clear(0);
    std::vector<Vertex> vertices = columns(0, 8, {0, 1, 1, 1}, {1, 1, 1, 1});
    for (Vertex vertex : columns(8, 16, {0, 1, 1, 1}, {1, 1, 1, 1})) {
        const float w = vertex.x > 0.5f ? 4.0f : 2.0f;
        vertices.push_back({w * vertex.x, w * vertex.y, 0, w, vertex.r, 1, 1, 1, 0, 0});
    }
    PixelProbe flat(3, 5), receding(13, 5);
    scene.gpu.set_stage_probe(&flat);
    scene.draw(PrimitiveType::Quads, vertices);
    scene.gpu.set_stage_probe(&receding);
    scene.draw(PrimitiveType::Quads, vertices);
    scene.gpu.finish();
    REQUIRE(std::count(flat.order.begin(), flat.order.end(), "perspective") == 1);
    CHECK(flat.inverse_w == 1);
    CHECK(flat.w == 1);
    // From 1/2 at the middle to 1/4 at the right.
    CHECK(receding.inverse_w / receding.inverse_w_left ==
          Approx((0.5 - 5.5 / 32) / (0.5 - 4.5 / 32)));
    CHECK(receding.w * receding.inverse_w == Approx(1));
}

TEST_CASE("the probe's derivatives on a cube are those on the face of what is covered") {
    Scene scene(16, 16);
    scene.clear(0);
    scene.texture(4, std::vector<std::uint32_t>(6 * 16));
    scene.registers.images[0].shape.kind = TextureKind::Cube;
    scene.registers.vertex_format.elements[Coordinate] = {3, 4};
    PixelProbe told(9, 5);
    scene.gpu.set_stage_probe(&told);
    // s is 1.2 at the centre of column 8, which is not drawn, and 0.8 at that of column 9, r is 1:
    // on face +z, (s / r + 1) / 2, column 9 is 0.2 to the left of 8. On face +x it would be 0.21.
    scene.draw(PrimitiveType::Quads, columns(9, 16, {1, 0, 1, 0}, {-1.8f, 0, 1, 0}));
    scene.gpu.finish();
    CHECK(told.probe.face == 4);
    CHECK(told.levels.step_x[0] == Approx(-0.2).epsilon(1e-4));
}
