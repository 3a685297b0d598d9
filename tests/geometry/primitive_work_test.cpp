// The work stream tells of each primitive behind which vertex it is assembled, and what became of
// it.

#include "tests/geometry/scene.h"

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

// Vertices inside the view volume, no two triangles alike.
Scene scattered(unsigned count) {
    Scene scene;
    scene.carry_color();
    Random random(count);
    for (unsigned i = 0; i < count; ++i)
        scene.vertex({random.between(-0.9f, 0.9f), random.between(-0.9f, 0.9f), 0, 1, 1, 1, 1, 1});
    return scene;
}

// GL 1.5, 2.6.1: primitive n of a type needs vertices up to this place.
std::uint32_t last_vertex(PrimitiveType type, std::uint32_t n, std::uint32_t count) {
    switch (type) {
    case PrimitiveType::Points:
        return n;
    case PrimitiveType::Lines:
        return 2 * n + 1;
    case PrimitiveType::LineStrip:
        return n + 1;
    case PrimitiveType::LineLoop:
        return std::min(n + 1, count - 1);
    case PrimitiveType::Triangles:
        return 3 * n + 2;
    case PrimitiveType::Quads: // Two triangles each.
        return n / 2 * 4 + 3;
    case PrimitiveType::QuadStrip:
        return n / 2 * 2 + 3;
    default:
        return n + 2;
    }
}

std::uint32_t primitives_of(PrimitiveType type, std::uint32_t count) {
    switch (type) {
    case PrimitiveType::Points:
    case PrimitiveType::LineLoop:
        return count;
    case PrimitiveType::Lines:
    case PrimitiveType::Quads:
        return count / 2;
    case PrimitiveType::LineStrip:
        return count - 1;
    case PrimitiveType::Triangles:
        return count / 3;
    default:
        return count - 2;
    }
}

TEST_CASE("each primitive is told with the last vertex that it needs, over chunks of a draw") {
    for (const std::uint32_t count : {12u, 2448u}) {
        Scene scene = scattered(count);
        for (unsigned i = 0; i <= static_cast<unsigned>(PrimitiveType::Polygon); ++i) {
            const auto type = static_cast<PrimitiveType>(i);
            const auto drawn = scene.draw(type);
            const auto& primitives = scene.work.primitives;
            INFO("type " << i << ", " << count << " vertices");
            REQUIRE(primitives.size() == primitives_of(type, count));
            std::size_t pieces = 0;
            for (std::uint32_t n = 0; n < primitives.size(); ++n) {
                REQUIRE(primitives[n].last_vertex == last_vertex(type, n, count));
                REQUIRE(primitives[n].planes == 0);
                pieces += primitives[n].pieces;
            }
            CHECK(pieces == drawn.size());
        }
    }
}

TEST_CASE("a primitive's fate: drawn in pieces, outside, culled, without area") {
    Scene scene;
    scene.carry_color();
    scene.registers.primitive.cull_back = true;
    const auto vertex = [&](float x, float y) { scene.vertex({x, y, 0, 1, 1, 1, 1, 1}); };
    const auto triangle = [&](float x, float width, float height) {
        vertex(x, 0), vertex(x + width, 0), vertex(x, height);
    };
    triangle(0, 0.5f, 0.5f);     // counter-clockwise
    triangle(0.5f, -0.5f, 0.5f); // clockwise
    triangle(0, 0, 0.5f);        // a line
    triangle(5, 0.5f, 0.5f);     // beside the view
    triangle(-0.5f, 4000, 0.5f); // cut at the guard band's right side
    scene.draw(PrimitiveType::Triangles);
    const auto& primitives = scene.work.primitives;
    REQUIRE(primitives.size() == 5);
    const auto is = [&](std::size_t n, PrimitiveFate fate, std::uint32_t pieces) {
        CHECK(primitives[n].key == n);
        CHECK(primitives[n].fate == fate);
        CHECK(primitives[n].pieces == pieces);
        CHECK((primitives[n].planes > 0) == (n == 4));
    };
    is(0, PrimitiveFate::Drawn, 1);
    is(1, PrimitiveFate::Culled, 0);
    is(2, PrimitiveFate::Degenerate, 0);
    is(3, PrimitiveFate::Outside, 0);
    is(4, PrimitiveFate::Drawn, 2); // A corner less makes four corners: two triangles.
    CHECK(scene.work.interpolants == scene.layout.count);
}

TEST_CASE("a polygon mode of lines leaves a primitive with a piece for each boundary edge") {
    Scene scene = scattered(4);
    scene.registers.primitive.front_mode = scene.registers.primitive.back_mode = PolygonMode::Line;
    const auto drawn = scene.draw(PrimitiveType::Quads);
    REQUIRE(scene.work.primitives.size() == 1);
    CHECK(scene.work.primitives[0].pieces == drawn.size());
    CHECK(drawn.size() == 4);
    CHECK(scene.work.primitives[0].last_vertex == 3);
}

} // namespace
} // namespace ffgpu
