// Primitive assembly: order, provoking vertices, facing, polygon modes, edge flags, stipple.

#include "tests/geometry/scene.h"

#include <set>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

// Vertex i lies on an arc of small steps, counter-clockwise, and is named by its red: i / 256.
Scene arc(unsigned count) {
    Scene scene;
    scene.carry_color();
    scene.registers.vertex_format.elements[static_cast<unsigned>(Attribute::EdgeFlag)] = {1, 8};
    scene.registers.vertex_format.stride = 9;
    for (unsigned i = 0; i < count; ++i) {
        const float x = static_cast<float>(i) / static_cast<float>(count) - 0.5f;
        scene.vertex({x, x * x - 0.5f, 0, 1, static_cast<float>(i) / 256, 0, 0, 1, 1});
    }
    return scene;
}

// "0 1 2, 1 2 3": the vertices of the primitives, by the place of their vertices in x.
std::string order(const Scene& scene, const std::vector<KeptPrimitive>& primitives) {
    std::string text;
    for (const KeptPrimitive& kept : primitives) {
        if (!text.empty()) text += ", ";
        const unsigned count = static_cast<unsigned>(kept.primitive.shape) + 1;
        for (unsigned v = 0; v < count; ++v) {
            const float x = static_cast<float>(kept[v].x) / 256 / 256;
            const auto i =
                static_cast<int>((x * 2 - 0.5f) * static_cast<float>(scene.vertex_count()) + 0.5f);
            if (v != 0) text += ' ';
            text += std::to_string(i);
        }
    }
    return text;
}

// The reds of all primitives, which must be equal within each: its provoking vertex.
std::string provoking(const std::vector<KeptPrimitive>& primitives) {
    std::string text;
    for (const KeptPrimitive& kept : primitives) {
        const unsigned count = static_cast<unsigned>(kept.primitive.shape) + 1;
        std::set<float> reds;
        for (unsigned v = 0; v < count; ++v)
            reds.insert(kept[v].attributes[0]);
        CHECK(reds.size() == 1);
        if (!text.empty()) text += ' ';
        text += std::to_string(static_cast<int>(*reds.begin() * 256));
    }
    return text;
}

struct Expected {
    PrimitiveType type;
    std::string order;
    std::string provoking;
};

TEST_CASE("each primitive type is assembled in GL's order with GL's provoking vertex") {
    const std::vector<Expected> table{
        {PrimitiveType::Points, "0, 1, 2, 3, 4, 5", "0 1 2 3 4 5"},
        {PrimitiveType::Lines, "0 1, 2 3, 4 5", "1 3 5"},
        {PrimitiveType::LineLoop, "0 1, 1 2, 2 3, 3 4, 4 5, 5 0", "1 2 3 4 5 0"},
        {PrimitiveType::LineStrip, "0 1, 1 2, 2 3, 3 4, 4 5", "1 2 3 4 5"},
        {PrimitiveType::Triangles, "0 1 2, 3 4 5", "2 5"},
        {PrimitiveType::TriangleStrip, "0 1 2, 2 1 3, 2 3 4, 4 3 5", "2 3 4 5"},
        {PrimitiveType::TriangleFan, "0 1 2, 0 2 3, 0 3 4, 0 4 5", "2 3 4 5"},
        {PrimitiveType::Quads, "0 1 3, 1 2 3", "3 3"},
        {PrimitiveType::QuadStrip, "2 0 3, 0 1 3, 4 2 5, 2 3 5", "3 3 5 5"},
        {PrimitiveType::Polygon, "0 1 2, 0 2 3, 0 3 4, 0 4 5", "0 0 0 0"},
    };
    for (const Expected& expected : table) {
        INFO("type " << static_cast<int>(expected.type));
        Scene scene = arc(6);
        CHECK(order(scene, scene.draw(expected.type)) == expected.order);
        scene.registers.primitive.flat_shading = true;
        CHECK(provoking(scene.draw(expected.type)) == expected.provoking);
    }
}

TEST_CASE("incomplete primitives at the end are not drawn") {
    const auto count = [](PrimitiveType type, unsigned vertices) {
        return arc(vertices).draw(type).size();
    };
    CHECK(count(PrimitiveType::Lines, 5) == 2);
    CHECK(count(PrimitiveType::LineStrip, 1) == 0);
    CHECK(count(PrimitiveType::LineLoop, 1) == 0);
    CHECK(count(PrimitiveType::LineLoop, 2) == 2);
    CHECK(count(PrimitiveType::Triangles, 5) == 1);
    CHECK(count(PrimitiveType::TriangleFan, 2) == 0);
    CHECK(count(PrimitiveType::Quads, 7) == 2);
    CHECK(count(PrimitiveType::QuadStrip, 5) == 2);
    CHECK(count(PrimitiveType::Polygon, 2) == 0);
}

TEST_CASE("pieces of a primitive share its key, keys count primitives") {
    std::vector<std::uint32_t> keys;
    for (const KeptPrimitive& kept : arc(8).draw(PrimitiveType::Quads))
        keys.push_back(kept.primitive.key);
    CHECK(keys == std::vector<std::uint32_t>{0, 0, 1, 1});
}

TEST_CASE("flat shading leaves the other interpolants alone") {
    Scene scene = arc(3);
    scene.layout.fog = 4;
    scene.layout.count = 5;
    scene.registers.fog.source = FogCoordinateSource::EyeZSigned;
    scene.registers.primitive.flat_shading = true;
    scene.words[2] = 0.25f;
    const auto kept = scene.draw(PrimitiveType::Triangles);
    REQUIRE(kept.size() == 1);
    CHECK(kept[0][0].attributes[4] == 0.25f);
    CHECK(kept[0][1].attributes[4] == 0);
}

TEST_CASE("facing follows the winding, the front register turns it round, culling takes its side") {
    Scene scene = arc(3); // counter-clockwise
    CHECK(scene.draw(PrimitiveType::Triangles).at(0).primitive.front_facing);
    scene.registers.primitive.front_is_clockwise = true;
    CHECK_FALSE(scene.draw(PrimitiveType::Triangles).at(0).primitive.front_facing);
    scene.registers.primitive.cull_front = true;
    CHECK(scene.draw(PrimitiveType::Triangles).size() == 1);
    scene.registers.primitive.cull_back = true;
    CHECK(scene.draw(PrimitiveType::Triangles).empty());
    CHECK(count_fate(scene.work, PrimitiveFate::Culled) == 1);
    CHECK(scene.draw(PrimitiveType::LineLoop).size() == 3); // Lines have no back.
}

TEST_CASE("a triangle without area after snapping is dropped as degenerate") {
    Scene scene = arc(3);
    scene.words[9] = scene.words[0] + 0x1p-18f; // The second vertex snaps onto the first.
    scene.words[10] = scene.words[1];
    CHECK(scene.draw(PrimitiveType::Triangles).empty());
    CHECK(count_fate(scene.work, PrimitiveFate::Degenerate) == 1);
}

TEST_CASE("a polygon in line mode is drawn as its outline, quads without their diagonal") {
    Scene scene = arc(4);
    scene.registers.primitive.front_mode = PolygonMode::Line;
    CHECK(order(scene, scene.draw(PrimitiveType::Quads)) == "0 1, 1 2, 2 3, 3 0");
    CHECK(order(scene, scene.draw(PrimitiveType::Polygon)) == "0 1, 1 2, 2 3, 3 0");
    CHECK(order(scene, scene.draw(PrimitiveType::TriangleFan)) == "0 1, 1 2, 2 0, 0 2, 2 3, 3 0");
    const auto kept = scene.draw(PrimitiveType::Quads);
    CHECK(kept[0].primitive.from_polygon);
    CHECK(kept[0].primitive.vertices[2] != nullptr); // The slope for the polygon's depth offset.
}

TEST_CASE(
    "only edges whose first vertex has its edge flag set are drawn, and only where flags count") {
    Scene scene = arc(4);
    scene.registers.primitive.front_mode = PolygonMode::Line;
    scene.words[9 + 8] = 0; // of vertex 1
    CHECK(order(scene, scene.draw(PrimitiveType::Quads)) == "0 1, 2 3, 3 0");
    CHECK(order(scene, scene.draw(PrimitiveType::Polygon)) == "0 1, 2 3, 3 0");
    CHECK(order(scene, scene.draw(PrimitiveType::Triangles)) == "0 1, 2 0");
    CHECK(order(scene, scene.draw(PrimitiveType::TriangleFan)) == "0 1, 1 2, 2 0, 0 2, 2 3, 3 0");
    scene.registers.primitive.front_mode = PolygonMode::Point;
    CHECK(order(scene, scene.draw(PrimitiveType::Quads)) == "0, 2, 3");
}

TEST_CASE("the two faces have their own modes, and filled ones stay as they were") {
    Scene scene = arc(4);
    scene.registers.primitive.back_mode = PolygonMode::Line;
    CHECK(order(scene, scene.draw(PrimitiveType::Quads)) == "0 1 3, 1 2 3");
    scene.registers.primitive.front_is_clockwise = true;
    CHECK(order(scene, scene.draw(PrimitiveType::Quads)) == "0 1, 1 2, 2 3, 3 0");
}

TEST_CASE("a polygon longer than a chunk keeps a closed outline") {
    Scene scene = arc(2000);
    scene.registers.primitive.front_mode = PolygonMode::Line;
    scene.registers.primitive.back_mode = PolygonMode::Line;
    const auto kept = scene.draw(PrimitiveType::Polygon);
    CHECK(kept.size() == 2000);
    for (std::size_t i = 0; i + 1 < kept.size(); ++i)
        REQUIRE(kept[i][1].x == kept[i + 1][0].x);
}

} // namespace
} // namespace ffgpu
