// ARB_depth_clamp: nothing is clipped at the near and far plane; window depth stops at the ends of
// the depth range, wherever it would pass them.

#include "tests/geometry/scene.h"

#include <algorithm>
#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

double area(const std::vector<KeptPrimitive>& pieces) {
    double sum = 0;
    for (const KeptPrimitive& t : pieces) {
        const auto x = [&](unsigned i) { return t[i].x / 256.0; };
        const auto y = [&](unsigned i) { return t[i].y / 256.0; };
        sum += (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
    }
    return sum;
}

// z runs from -2 to 2 along x: the near and the far plane are at x = -0.5 and x = 0.5. Red is x.
Scene sloped_square() {
    Scene scene;
    scene.registers.viewport.clamp_depth = true;
    scene.registers.viewport.near_depth = 0.25f;
    scene.registers.viewport.far_depth = 0.75f;
    scene.carry_color();
    scene.vertex({-1, -1, -2, 1, 0, 0, 0, 1});
    scene.vertex({1, -1, 2, 1, 1, 0, 0, 1});
    scene.vertex({1, 1, 2, 1, 1, 1, 0, 1});
    scene.vertex({-1, 1, -2, 1, 0, 1, 0, 1});
    return scene;
}

double clamped_depth(double x) { // x from 0 to 1
    return std::clamp(0.5 + (x - 0.5), 0.25, 0.75);
}

void check_slope(const std::vector<KeptPrimitive>& pieces, unsigned corners) {
    for (const KeptPrimitive& piece : pieces) {
        double low = 1, high = 0;
        for (unsigned v = 0; v < corners; ++v) {
            const double x = piece[v].x / 65536.0;
            CHECK(std::fabs(piece[v].depth - clamped_depth(x)) < 1e-6);
            CHECK(std::fabs(piece[v].attributes[0] - x) < 1e-6);
            low = std::min(low, x);
            high = std::max(high, x);
        }
        // No piece spans a plane: there depth would not be linear.
        for (const double plane : {0.25, 0.75})
            CHECK_FALSE((low < plane - 1e-6 && high > plane + 1e-6));
    }
}

} // namespace

TEST_CASE("a clamped polygon keeps its area; its depth bends at the planes") {
    const auto pieces = sloped_square().draw(PrimitiveType::Quads);
    CHECK(area(pieces) == 2.0 * 256 * 256);
    check_slope(pieces, 3);
}

TEST_CASE("a depth range that runs backwards clamps to its own ends") {
    Scene scene = sloped_square();
    std::swap(scene.registers.viewport.near_depth, scene.registers.viewport.far_depth);
    for (const KeptPrimitive& piece : scene.draw(PrimitiveType::Quads))
        for (unsigned v = 0; v < 3; ++v)
            CHECK(std::fabs(piece[v].depth - (1 - clamped_depth(piece[v].x / 65536.0))) < 1e-6);
}

TEST_CASE("primitives wholly before the near plane are drawn whole, at its depth") {
    Scene scene = sloped_square();
    for (std::size_t vertex = 0; vertex < 4; ++vertex)
        scene.words[8 * vertex + 2] = -5 - static_cast<float>(vertex);
    for (const PrimitiveType type :
         {PrimitiveType::Quads, PrimitiveType::LineStrip, PrimitiveType::Points}) {
        const auto pieces = scene.draw(type);
        CHECK(pieces.size() == (type == PrimitiveType::Quads       ? 2
                                : type == PrimitiveType::LineStrip ? 3
                                                                   : 4));
        CHECK(count_clipped(scene.work) == 0);
        for (const KeptPrimitive& piece : pieces)
            CHECK(piece[0].depth == 0.25f);
    }
    scene.registers.viewport.clamp_depth = false;
    CHECK(scene.draw(PrimitiveType::Quads).empty());
}

TEST_CASE("clamped lines, and outlines of polygons, bend as well and count their stipple on") {
    Scene scene = sloped_square();
    scene.registers.primitive.line_stipple = true;
    const auto lines = scene.draw(PrimitiveType::Lines);
    REQUIRE(lines.size() == 6); // two lines of three parts
    check_slope(lines, 2);
    CHECK(lines[0].primitive.stipple_counter == 0);
    CHECK(lines[1].primitive.stipple_counter == 64 % 16);
    CHECK(lines[2][1].x == 256 * 256);

    scene.registers.primitive.front_mode = PolygonMode::Line;
    const auto outline = scene.draw(PrimitiveType::Quads);
    CHECK(outline.size() == 8); // two sides of three parts, two whole
    check_slope(outline, 2);
    scene.registers.primitive.front_mode = PolygonMode::Point;
    CHECK(scene.draw(PrimitiveType::Quads).size() == 4); // The cuts are no corners.
}

TEST_CASE("a clamped triangle that passes behind the eye is cut before the division alone") {
    Scene scene;
    scene.registers.viewport.clamp_depth = true;
    scene.carry_color();
    scene.registers.transform.projection = {
        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.0202f, -1, 0, 0, -0.20202f, 0};
    scene.vertex({-1, -1, -200, 1, 0, 0, 0, 1}); // beyond the far plane at 10
    scene.vertex({1, -1, -200, 1, 0, 0, 0, 1});
    scene.vertex({0, -1, 10, 1, 1, 0, 0, 1});
    bool at_near = false, at_far = false;
    for (const KeptPrimitive& piece : scene.draw(PrimitiveType::Triangles))
        for (unsigned v = 0; v < 3; ++v) {
            REQUIRE(piece[v].inverse_w > 0);
            REQUIRE(piece[v].depth >= 0);
            REQUIRE(piece[v].depth <= 1);
            at_near = at_near || piece[v].depth == 0;
            at_far = at_far || piece[v].depth == 1;
        }
    CHECK(at_near);
    CHECK(at_far);
}

} // namespace ffgpu
