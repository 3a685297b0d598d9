// Clipping: what is left has the right area, attributes and neighbours, and stays where the
// rasterizer can work.

#include "tests/geometry/scene.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

// Twice the signed area in pixels.
double area(const KeptPrimitive& t) {
    const auto x = [&](unsigned i) { return t[i].x / 256.0; };
    const auto y = [&](unsigned i) { return t[i].y / 256.0; };
    return (x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0));
}

double area(const std::vector<KeptPrimitive>& pieces) {
    double sum = 0;
    for (const KeptPrimitive& piece : pieces)
        sum += area(piece);
    return sum;
}

// A square of the view volume's size, red = x and green = y in normalised device coordinates.
Scene colored_square(float half) {
    Scene scene;
    scene.carry_color();
    for (const auto& [x, y] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}})
        scene.vertex({x * half, y * half, 0, 1, (x * half + 4) / 8, (y * half + 4) / 8, 0, 1});
    return scene;
}

bool color_is_position(const WindowVertex& v) {
    const double x = v.x / 256.0 / 128 - 1, y = v.y / 256.0 / 128 - 1;
    return std::fabs(v.attributes[0] * 8 - 4 - x) < 0.001 &&
           std::fabs(v.attributes[1] * 8 - 4 - y) < 0.001;
}

TEST_CASE("inside the guard band triangles stay whole where the scissor covers what lies outside") {
    const auto pieces = colored_square(3).draw(PrimitiveType::Quads);
    CHECK(pieces.size() == 2);
    CHECK(area(pieces) == 2.0 * 768 * 768);
}

TEST_CASE("a viewport smaller than the scissor clips exactly") {
    Scene scene = colored_square(3);
    scene.registers.scissor.width = 257;
    const auto pieces = scene.draw(PrimitiveType::Quads);
    CHECK(count_clipped(scene.work) == 2);
    CHECK(area(pieces) == 2.0 * 256 * 256);
    for (const KeptPrimitive& piece : pieces)
        for (unsigned v = 0; v < 3; ++v)
            CHECK(color_is_position(piece[v]));
}

TEST_CASE("a scissor larger than the target does not force exact clipping") {
    Scene scene = colored_square(3);
    scene.registers.scissor = {.x = -10, .y = -10, .width = 5000, .height = 5000};
    scene.registers.targets.color[0] = {.format = Format::Rgba8, .width = 256, .height = 256};
    scene.draw(PrimitiveType::Quads);
    CHECK(count_clipped(scene.work) == 0);
    scene.registers.targets.color[0].width = 257;
    scene.draw(PrimitiveType::Quads);
    CHECK(count_clipped(scene.work) == 2);
}

TEST_CASE("beyond the guard band triangles are cut to it") {
    Scene scene = colored_square(3);
    for (std::size_t vertex = 0; vertex < 4; ++vertex)
        for (std::size_t c = 0; c < 2; ++c)
            scene.words[8 * vertex + c] *= 1000;
    const auto pieces = scene.draw(PrimitiveType::Quads);
    CHECK(count_clipped(scene.work) == 2);
    const double side = 2 * (GuardBand - 1);
    CHECK(std::fabs(area(pieces) / (2 * side * side) - 1) < 1e-5);
    for (const KeptPrimitive& piece : pieces)
        for (unsigned v = 0; v < 3; ++v) {
            CHECK(std::abs(piece[v].x) <= GuardBand * 256);
            CHECK(std::abs(piece[v].y) <= GuardBand * 256);
        }
}

TEST_CASE("what lies outside one plane as a whole is rejected") {
    for (const auto& [axis, offset] :
         {std::pair{0u, 4.5f}, {0u, -4.5f}, {1u, 4.5f}, {1u, -4.5f}, {2u, 1.5f}, {2u, -1.5f}}) {
        Scene scene = colored_square(3);
        for (std::size_t vertex = 0; vertex < 4; ++vertex)
            scene.words[8 * vertex + axis] += offset;
        CHECK(scene.draw(PrimitiveType::Quads).empty());
        CHECK(count_fate(scene.work, PrimitiveFate::Outside) == 2);
        CHECK(scene.draw(PrimitiveType::LineLoop).empty());
    }
}

TEST_CASE("cuts at the near plane have its depth, the plane's share of the area, and attributes on "
          "the line") {
    Scene scene;
    scene.carry_color();
    // z runs from -2 to 2 along x: the near and the far plane cut at x = -0.5 and x = 0.5.
    scene.vertex({-1, -1, -2, 1, 0, 0, 0, 1});
    scene.vertex({1, -1, 2, 1, 1, 0, 0, 1});
    scene.vertex({1, 1, 2, 1, 1, 1, 0, 1});
    scene.vertex({-1, 1, -2, 1, 0, 1, 0, 1});
    const auto pieces = scene.draw(PrimitiveType::Quads);
    CHECK(area(pieces) == 2.0 * 128 * 256);
    for (const KeptPrimitive& piece : pieces)
        for (unsigned v = 0; v < 3; ++v) {
            const WindowVertex& vertex = piece[v];
            const double x = vertex.x / 65536.0;
            CHECK(std::fabs(vertex.attributes[0] - x) < 1e-6);
            CHECK(std::fabs(vertex.depth - (2 * x - 0.5)) < 1e-6);
        }
}

// In homogeneous coordinates: a floor that runs from before the eye to behind it.
TEST_CASE("a triangle that passes behind the eye is cut before the division") {
    Scene scene;
    scene.carry_color();
    scene.registers.transform.projection = {
        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.0202f, -1, 0, 0, -0.20202f, 0};
    scene.vertex({-1, -1, -10, 1, 0.1f, 0, 0, 1});
    scene.vertex({1, -1, -10, 1, 0.1f, 0, 0, 1});
    scene.vertex({0, -1, 10, 1, 0.9f, 0, 0, 1});
    const auto pieces = scene.draw(PrimitiveType::Triangles);
    REQUIRE_FALSE(pieces.empty());
    for (const KeptPrimitive& piece : pieces)
        for (unsigned v = 0; v < 3; ++v) {
            REQUIRE(piece[v].inverse_w > 0);
            const double z = -1 / piece[v].inverse_w;
            CHECK(std::fabs(piece[v].attributes[0] - (0.5 + 0.04 * z)) < 1e-4);
            CHECK(z <= -0.0999);
        }
}

TEST_CASE("user planes cut in eye space, all six") {
    for (unsigned plane = 0; plane < ClipPlanes; ++plane) {
        Scene scene = colored_square(1);
        scene.registers.transform.model_view[12] = 0.25f; // The plane x_eye >= 0 is x >= -0.25.
        scene.registers.clip_planes.enable = static_cast<std::uint8_t>(1u << plane);
        scene.registers.clip_planes.planes[plane] = {1, 0, 0, 0};
        // Window x from 128 to 256 + 32, clipped by nothing else (guard band).
        CHECK(area(scene.draw(PrimitiveType::Quads)) == 2.0 * 160 * 256);
        CHECK(scene.draw(PrimitiveType::Points).empty()); // The right ones leave the view.
        scene.registers.clip_planes.planes[plane] = {1, 0, 0, -10};
        CHECK(scene.draw(PrimitiveType::Quads).empty());
    }
}

TEST_CASE("a shared edge is cut at the same place in both triangles") {
    Random random(31);
    for (int round = 0; round < 300; ++round) {
        Scene scene;
        scene.carry_color();
        for (unsigned v = 0; v < 4; ++v) {
            for (unsigned c = 0; c < 3; ++c)
                scene.words.push_back(random.between(-6, 6));
            scene.words.push_back(random.between(-1, 4));
            for (unsigned c = 0; c < 4; ++c)
                scene.words.push_back(random.between(0, 1));
        }
        scene.registers.scissor.width = 300; // exact
        const auto cuts_of = [&](std::vector<std::uint32_t> indices) {
            scene.indices = std::move(indices);
            std::vector<std::pair<int, int>> cuts;
            for (const KeptPrimitive& piece : scene.draw(PrimitiveType::LineStrip))
                cuts.insert(cuts.end(), {{piece[0].x, piece[0].y}, {piece[1].x, piece[1].y}});
            return cuts;
        };
        auto there = cuts_of({0, 1}), back = cuts_of({1, 0});
        std::reverse(back.begin(), back.end());
        CHECK(there == back);
    }
}

TEST_CASE("cuts of an edge are the same number to the last bit from either end") {
    Random random(33);
    Scene scene;
    const DrawState state = scene.state();
    const VertexSetup setup = make_vertex_setup(state.regs(), scene.layout, {});
    Clipper clipper;
    clipper.start(setup);
    for (int round = 0; round < 2000; ++round) {
        std::array<Vec4, 4> corners;
        for (Vec4& corner : corners)
            for (float& c : corner)
                c = random.between(-3, 3);
        const auto cuts_of_edge = [&](std::array<std::uint32_t, 3> order) {
            clipper.clear();
            std::array<ClipCorner, 3> polygon;
            for (unsigned i = 0; i < 3; ++i)
                polygon[i] = {clipper.add(order[i], corners[order[i]], {})};
            std::set<std::array<double, 4>> cuts;
            const ClipCode codes = clip_code::Near;
            for (const ClipCorner& corner :
                 clipper.clip_polygon(polygon, codes, Clipper::Bounds::Polygon)) {
                const ClipVertex& vertex = clipper.vertex(corner.vertex);
                if (!vertex.made) continue;
                const auto slots =
                    std::minmax(clipper.vertex(vertex.from).slot, clipper.vertex(vertex.to).slot);
                if (slots.first == 0 && slots.second == 1) cuts.insert(vertex.clip);
            }
            return cuts;
        };
        REQUIRE(cuts_of_edge({0, 1, 2}) == cuts_of_edge({1, 0, 3}));
    }
}

// Against Monte Carlo sampling of the original triangle in homogeneous coordinates.
TEST_CASE("random triangles keep exactly the part inside the view volume") {
    Random random(32);
    for (int round = 0; round < 60; ++round) {
        Scene scene;
        scene.registers.scissor.width = 300; // exact
        std::array<std::array<double, 4>, 3> clip;
        for (auto& vertex : clip) {
            for (unsigned c = 0; c < 4; ++c)
                scene.words.push_back(random.between(c == 3 ? -0.5f : -2.0f, 2));
            std::copy(scene.words.end() - 4, scene.words.end(), vertex.begin());
        }
        const auto pieces = scene.draw(PrimitiveType::Triangles);
        for (const KeptPrimitive& piece : pieces) // No sliver that snapping turned over.
            CHECK((area(piece) > 0) == piece.primitive.front_facing);
        const auto contains = [&](double x, double y) {
            for (const KeptPrimitive& piece : pieces) {
                bool inside = true;
                for (unsigned i = 0; i < 3; ++i) {
                    const WindowVertex &a = piece[i], &b = piece[(i + 1) % 3];
                    const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
                    inside &= area(piece) > 0 ? side >= 0 : side <= 0;
                }
                if (inside) return true;
            }
            return false;
        };
        unsigned wrong = 0, visible = 0;
        for (int sample = 0; sample < 500; ++sample) {
            double a = random.between(0, 1), b = random.between(0, 1);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            std::array<double, 4> p;
            for (unsigned c = 0; c < 4; ++c)
                p[c] = clip[0][c] + a * (clip[1][c] - clip[0][c]) + b * (clip[2][c] - clip[0][c]);
            const bool in_view = p[3] > 0 && std::fabs(p[0]) <= p[3] && std::fabs(p[1]) <= p[3] &&
                                 std::fabs(p[2]) <= p[3];
            if (!in_view) continue;
            ++visible;
            wrong += !contains((p[0] / p[3] + 1) * 32768, (p[1] / p[3] + 1) * 32768);
        }
        CHECK(wrong <= visible / 50); // Samples within 1/256 pixel of an edge.
        for (const KeptPrimitive& piece : pieces)
            for (unsigned v = 0; v < 3; ++v) {
                CHECK((piece[v].x >= 0 && piece[v].x <= 65536));
                CHECK((piece[v].y >= 0 && piece[v].y <= 65536));
            }
    }
}

TEST_CASE("lines are clipped to the view volume, guard band or not, and interpolate") {
    Scene scene;
    scene.carry_color();
    scene.vertex({-3, 0, 0, 1, 0, 0, 0, 1});
    scene.vertex({3, 0, 0, 1, 1, 0, 0, 1});
    const auto kept = scene.draw(PrimitiveType::Lines);
    REQUIRE(kept.size() == 1);
    CHECK(kept[0][0].x == 0);
    CHECK(kept[0][1].x == 65536);
    CHECK(std::fabs(kept[0][0].attributes[0] - 1 / 3.0) < 1e-6);
    CHECK(std::fabs(kept[0][1].attributes[0] - 2 / 3.0) < 1e-6);
    CHECK(count_clipped(scene.work) == 1);
    scene.registers.primitive.flat_shading = true;
    CHECK(scene.draw(PrimitiveType::Lines)[0][0].attributes[0] == 1);
}

TEST_CASE("a line that passes a corner of the view volume outside is rejected") {
    Scene scene;
    scene.vertex({-2.25f, 0, 0, 1});
    scene.vertex({0, 2.25f, 0, 1});
    CHECK(scene.draw(PrimitiveType::Lines).empty());
    CHECK(count_fate(scene.work, PrimitiveFate::Outside) == 1);
}

TEST_CASE("a point is drawn if its centre is inside, the boundary included") {
    Scene scene;
    scene.registers.primitive.point_size = 64;
    for (const float x : {-1.0f, 1.0f, 1.0000001f, -1.0000001f})
        scene.vertex({x, 0, 0, 1});
    CHECK(scene.draw(PrimitiveType::Points).size() == 2);
    CHECK(count_fate(scene.work, PrimitiveFate::Outside) == 2);
}

TEST_CASE("in line mode the edges that clipping makes are drawn, and cut edges keep their flags") {
    Scene scene = colored_square(1);
    scene.registers.primitive.front_mode = PolygonMode::Line;
    scene.registers.clip_planes.enable = 1;
    scene.registers.clip_planes.planes[0] = {1, 0, 0, 0};
    const auto kept = scene.draw(PrimitiveType::Quads);
    REQUIRE(kept.size() == 4);
    unsigned along_the_plane = 0;
    for (const KeptPrimitive& line : kept)
        along_the_plane += line[0].x == 32768 && line[1].x == 32768;
    CHECK(along_the_plane == 1);
}

TEST_CASE("an edge without flag stays undrawn when cut, the edge along the plane is drawn") {
    Scene scene = colored_square(1);
    scene.carry(Attribute::EdgeFlag, 1);
    std::vector<float> words;
    for (std::size_t vertex = 0; vertex < 4; ++vertex) {
        words.insert(words.end(),
                     scene.words.begin() + static_cast<std::ptrdiff_t>(8 * vertex),
                     scene.words.begin() + static_cast<std::ptrdiff_t>(8 * vertex + 8));
        words.push_back(vertex % 2 ? 1.0f : 0.0f); // The lower and the upper edge have none.
    }
    scene.words = words;
    scene.registers.primitive.front_mode = PolygonMode::Line;
    scene.registers.clip_planes.enable = 1;
    scene.registers.clip_planes.planes[0] = {-1, 0, 0, 0}; // keeps the left half
    const auto kept = scene.draw(PrimitiveType::Quads);
    REQUIRE(kept.size() == 2);
    CHECK((kept[0][0].x == 32768 && kept[0][1].x == 32768));
    CHECK((kept[1][0].x == 0 && kept[1][1].x == 0));
}

TEST_CASE("points at cuts of a polygon in point mode have their size") {
    Scene scene = colored_square(1);
    scene.registers.primitive.front_mode = PolygonMode::Point;
    scene.registers.primitive.point_size = 5;
    scene.registers.clip_planes.enable = 1;
    scene.registers.clip_planes.planes[0] = {1, 0, 0, 0};
    const auto kept = scene.draw(PrimitiveType::Quads);
    REQUIRE(kept.size() == 4);
    for (const KeptPrimitive& point : kept)
        CHECK(point[0].point_size == 5);
}

TEST_CASE("flat colours are chosen before clipping") {
    Scene scene = colored_square(1);
    scene.registers.primitive.flat_shading = true;
    scene.registers.clip_planes.enable = 1;
    scene.registers.clip_planes.planes[0] = {1, 0, 0, 0}; // Takes the provoking vertex away.
    const auto kept = scene.draw(PrimitiveType::Quads);
    REQUIRE_FALSE(kept.empty());
    for (const KeptPrimitive& piece : kept)
        for (unsigned v = 0; v < 3; ++v)
            CHECK(piece[v].attributes[0] == 3.0f / 8);
}

TEST_CASE("a polygon that zigzags over a plane is clipped without end of room") {
    Scene scene;
    scene.registers.primitive.front_mode = PolygonMode::Line;
    scene.registers.primitive.back_mode = PolygonMode::Line;
    scene.registers.clip_planes.enable = 0x3f;
    for (unsigned plane = 0; plane < ClipPlanes; ++plane) {
        const float angle = 0.1f * static_cast<float>(plane);
        scene.registers.clip_planes.planes[plane] = {1, angle, 0, 0};
    }
    for (unsigned i = 0; i < 5000; ++i)
        scene.vertex({i % 2 ? 0.9f : -0.9f, static_cast<float>(i) / 5000 - 0.5f, 0, 1});
    CHECK(scene.draw(PrimitiveType::Polygon).size() > 5000);
}

} // namespace
} // namespace ffgpu
