// The line stipple's counter: where it begins anew, where it goes on, and by how much.

#include "tests/geometry/scene.h"

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

// Vertices in pixels of a window of 256 x 256.
Scene pixels(std::initializer_list<std::pair<float, float>> corners) {
    Scene scene;
    scene.registers.primitive.line_stipple = true;
    scene.registers.primitive.line_stipple_factor = 256; // The counter does not wrap soon.
    scene.registers.transform.projection = {
        1.0f / 128, 0, 0, 0, 0, 1.0f / 128, 0, 0, 0, 0, 1, 0, -1, -1, 0, 1};
    for (const auto& [x, y] : corners)
        scene.vertex({x, y, 0, 1});
    return scene;
}

std::vector<int> counters(const std::vector<KeptPrimitive>& lines) {
    std::vector<int> result;
    for (const KeptPrimitive& line : lines)
        result.push_back(line.primitive.stipple_counter);
    return result;
}

TEST_CASE("separate lines begin anew, strips and loops go on") {
    Scene scene = pixels({{10.5f, 10.5f}, {20.5f, 10.5f}, {20.5f, 15.5f}, {10.5f, 10.5f}});
    CHECK(counters(scene.draw(PrimitiveType::Lines)) == std::vector<int>{0, 0});
    CHECK(counters(scene.draw(PrimitiveType::LineStrip)) == std::vector<int>{0, 10, 15});
    scene = pixels({{10.5f, 10.5f}, {20.5f, 10.5f}, {20.5f, 15.5f}});
    CHECK(counters(scene.draw(PrimitiveType::LineLoop)) == std::vector<int>{0, 10, 15});
}

TEST_CASE("polygons in line mode begin anew and go on along their outline") {
    Scene scene = pixels({{10.5f, 10.5f},
                          {20.5f, 10.5f},
                          {20.5f, 15.5f},
                          {10.5f, 15.5f},
                          {30.5f, 10.5f},
                          {40.5f, 10.5f},
                          {40.5f, 15.5f},
                          {30.5f, 15.5f}});
    scene.registers.primitive.front_mode = PolygonMode::Line;
    CHECK(counters(scene.draw(PrimitiveType::Quads)) ==
          std::vector<int>{0, 10, 15, 25, 0, 10, 15, 25});
}

TEST_CASE("the counter goes on from the draw before where the command says so") {
    Scene scene = pixels({{10.5f, 10.5f}, {20.5f, 10.5f}});
    scene.fill_memory();
    GeometryUnit unit(scene.memory);
    KeepingSink sink;
    const DrawState state = scene.state();
    DrawCommand command = scene.command(PrimitiveType::LineStrip);
    unit.draw(state, command, sink);
    command.continue_line_stipple = true;
    unit.draw(state, command, sink);
    unit.draw(state, command, sink);
    command.continue_line_stipple = false;
    unit.draw(state, command, sink);
    CHECK(counters(sink.kept) == std::vector<int>{0, 10, 20, 0});
}

TEST_CASE("the counter stays within the pattern's period of 16 times the factor") {
    Scene scene = pixels({{0.5f, 10.5f}, {100.5f, 10.5f}, {120.5f, 10.5f}});
    scene.registers.primitive.line_stipple_factor = 5;
    CHECK(counters(scene.draw(PrimitiveType::LineStrip)) == std::vector<int>{0, 100 % 80});
}

TEST_CASE("a part that is clipped away does not count") {
    Scene scene = pixels({{-99.5f, 10.5f}, {20.5f, 10.5f}, {30.5f, 10.5f}});
    // Pixels 0 to 19, and the one before, in whose diamond the cut at x = 0 lies.
    CHECK(counters(scene.draw(PrimitiveType::LineStrip)) == std::vector<int>{0, 21});
}

TEST_CASE("without stipple nothing is counted") {
    Scene scene = pixels({{10.5f, 10.5f}, {20.5f, 10.5f}, {20.5f, 15.5f}});
    scene.registers.primitive.line_stipple = false;
    CHECK(counters(scene.draw(PrimitiveType::LineStrip)) == std::vector<int>{0, 0});
}

} // namespace
} // namespace ffgpu
