// Feedback: records in device memory, after clipping and culling.

#include "tests/geometry/scene.h"

#include <bit>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

struct Record {
    std::uint32_t kind;
    std::vector<std::array<float, FeedbackVertexWords>> vertices;
};

struct FeedbackScene : Scene {
    FeedbackScene() {
        carry_color();
        carry(Attribute::TexCoord0, 2);
        layout = {}; // What the draw's fragments would need does not matter.
    }

    std::uint32_t run(PrimitiveType type, std::uint32_t bytes = 4096) {
        fill_memory(8192);
        GeometryUnit unit(memory);
        DrawCommand draw_command = command(type);
        draw_command.output = DrawOutput::Feedback;
        draw_command.feedback_address = static_cast<DeviceAddress>(words.size() * 4 + 64);
        draw_command.feedback_bytes = bytes;
        unit.feedback(state(), draw_command, memory);
        at = draw_command.feedback_address;
        return word();
    }

    std::uint32_t word() {
        std::uint32_t value = 0;
        std::memcpy(&value, memory.data() + at, 4);
        at += 4;
        return value;
    }

    std::vector<Record> records(PrimitiveType type) {
        std::vector<Record> result;
        const std::uint32_t bytes = run(type);
        for (const std::size_t end = at + bytes; at < end;) {
            Record record{word(), {}};
            record.vertices.resize(word());
            for (auto& vertex : record.vertices)
                for (float& value : vertex)
                    value = std::bit_cast<float>(word());
            result.push_back(record);
        }
        return result;
    }

    std::size_t at = 0;
};

void add_square(FeedbackScene& scene, float half) {
    for (const auto& [x, y] : {std::pair{-1.f, -1.f}, {1.f, -1.f}, {1.f, 1.f}, {-1.f, 1.f}})
        scene.vertex({x * half, y * half, 0, 1, 0.25f, 0.5f, 0.75f, 1, x, y});
}

constexpr auto Polygon = static_cast<std::uint32_t>(FeedbackKind::Polygon);
constexpr auto Point = static_cast<std::uint32_t>(FeedbackKind::Point);
constexpr auto Line = static_cast<std::uint32_t>(FeedbackKind::Line);
constexpr auto LineReset = static_cast<std::uint32_t>(FeedbackKind::LineReset);

TEST_CASE("a quad is one polygon with its vertices' window coordinates, colours, coordinates") {
    FeedbackScene scene;
    add_square(scene, 0.5f);
    const auto records = scene.records(PrimitiveType::Quads);
    REQUIRE(records.size() == 1);
    CHECK(records[0].kind == Polygon);
    REQUIRE(records[0].vertices.size() == 4);
    CHECK(records[0].vertices[2] == std::array<float, FeedbackVertexWords>{
                                        192, 192, 0.5f, 1, 0.25f, 0.5f, 0.75f, 1, 1, 1, 0, 1});
}

TEST_CASE("polygons are clipped exactly, guard band or not") {
    FeedbackScene scene;
    add_square(scene, 2);
    const auto records = scene.records(PrimitiveType::Quads);
    REQUIRE(records.size() == 1);
    for (const auto& vertex : records[0].vertices) {
        CHECK((vertex[0] == 0 || vertex[0] == 256));
        CHECK((vertex[1] == 0 || vertex[1] == 256));
    }
}

TEST_CASE("culled and outside primitives leave no record") {
    FeedbackScene scene;
    add_square(scene, 0.5f);
    scene.registers.primitive.cull_front = true;
    CHECK(scene.run(PrimitiveType::Quads) == 0);
    CHECK(scene.records(PrimitiveType::Points).size() == 4);
}

TEST_CASE("lines tell where the stipple begins anew, polygon modes apply") {
    FeedbackScene scene;
    add_square(scene, 0.5f);
    const auto kinds = [&](PrimitiveType type) {
        std::vector<std::uint32_t> result;
        for (const Record& record : scene.records(type))
            result.push_back(record.kind);
        return result;
    };
    using Kinds = std::vector<std::uint32_t>;
    CHECK(kinds(PrimitiveType::Lines) == Kinds{LineReset, LineReset});
    CHECK(kinds(PrimitiveType::LineStrip) == Kinds{LineReset, Line, Line});
    scene.registers.primitive.front_mode = PolygonMode::Line;
    CHECK(kinds(PrimitiveType::Quads) == Kinds{LineReset, Line, Line, Line});
    scene.registers.primitive.front_mode = PolygonMode::Point;
    CHECK(kinds(PrimitiveType::Quads) == Kinds{Point, Point, Point, Point});
}

TEST_CASE("a buffer that is too small by a word says so, one that just fits does not") {
    FeedbackScene scene;
    add_square(scene, 0.5f);
    const std::uint32_t bytes = 4 * (2 + 4 * FeedbackVertexWords);
    CHECK(scene.run(PrimitiveType::Quads, 4 + bytes) == bytes);
    CHECK(scene.run(PrimitiveType::Quads, bytes) == 0xffffffff);
    CHECK(scene.run(PrimitiveType::Quads, 4) == 0xffffffff);
    CHECK(scene.run(PrimitiveType::Quads, 3) == 0); // No room for the first word: dropped.
    CHECK(scene.run(PrimitiveType::Quads, 0xffffffff) == 0);
}

} // namespace
} // namespace ffgpu
