#include "driver/vertex/immediate_vertices.h"
#include "tests/driver/draw_fixture.h"

#include <numeric>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
namespace entry = ffgpu::gl::entry;
using Value = std::array<float, 4>;

namespace {

void vertices(int count, float first = 0) {
    for (int i = 0; i < count; ++i)
        entry::Vertex3f(first + static_cast<float>(i), 1, 2);
}

std::vector<float> count_up(float first, std::size_t count) {
    std::vector<float> all(count);
    std::iota(all.begin(), all.end(), first);
    return all;
}

} // namespace

TEST_CASE_METHOD(DrawFixture, "a primitive becomes one draw of its vertices") {
    entry::Begin(GL_TRIANGLES);
    vertices(3);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(all[0].primitive == PrimitiveType::Triangles);
    CHECK(names(all[0]) == count_up(0, 3));
    CHECK(position(all[0], 2) == Value{2, 1, 2, 1});
    CHECK(device.registers.vertex_format.stride == 3);
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "pairs of an independent primitive are drawn together") {
    for (int i = 0; i < 5; ++i) {
        entry::Begin(GL_QUADS);
        vertices(4, static_cast<float>(4 * i));
        entry::End();
    }
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == count_up(0, 20));
}

TEST_CASE_METHOD(DrawFixture, "strips that follow each other share memory but not a draw") {
    for (int i = 0; i < 2; ++i) {
        entry::Begin(GL_TRIANGLE_STRIP);
        vertices(4, static_cast<float>(4 * i));
        entry::End();
    }
    const auto all = draws();
    REQUIRE(all.size() == 2);
    CHECK(all[0].vertex_address == all[1].vertex_address);
    CHECK(names(all[1]) == count_up(4, 4));
}

TEST_CASE_METHOD(DrawFixture, "a change of state between two primitives keeps them apart") {
    entry::Begin(GL_POINTS);
    vertices(1);
    entry::End();
    entry::PointSize(3);
    CHECK(device.commands.size() == 1);
    entry::Begin(GL_POINTS);
    vertices(1);
    entry::End();
    CHECK(draws().size() == 2);
}

TEST_CASE_METHOD(DrawFixture, "vertices that make no whole primitive are ignored") {
    const auto drawn = [&](GLenum mode, int count) {
        entry::Begin(mode);
        vertices(count);
        entry::End();
        std::uint32_t sum = 0;
        for (const DrawCommand& draw : draws())
            sum += draw.count;
        return sum;
    };
    CHECK(drawn(GL_POINTS, 1) == 1);
    CHECK(drawn(GL_LINES, 3) == 2);
    CHECK(drawn(GL_LINE_STRIP, 1) == 0);
    CHECK(drawn(GL_LINE_LOOP, 2) == 2);
    CHECK(drawn(GL_TRIANGLES, 5) == 3);
    CHECK(drawn(GL_TRIANGLE_STRIP, 2) == 0);
    CHECK(drawn(GL_TRIANGLE_FAN, 3) == 3);
    CHECK(drawn(GL_QUADS, 7) == 4);
    CHECK(drawn(GL_QUAD_STRIP, 5) == 4);
    CHECK(drawn(GL_POLYGON, 2) == 0);
}

TEST_CASE_METHOD(DrawFixture,
                 "an attribute that comes up late leaves earlier vertices as they were") {
    entry::Color3f(0.25f, 0.5f, 0.75f);
    entry::Begin(GL_TRIANGLES);
    vertices(2);
    entry::Color4f(1, 0, 0, 0.5f);
    vertices(1, 2);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{0.25f, 0.5f, 0.75f, 1});
    CHECK(attribute(all[0], 1, Attribute::Color) == Value{0.25f, 0.5f, 0.75f, 1});
    CHECK(attribute(all[0], 2, Attribute::Color) == Value{1, 0, 0, 0.5f});
    CHECK(names(all[0]) == count_up(0, 3));
}

TEST_CASE_METHOD(DrawFixture, "fewer components than before set the rest to 0, 0, 1") {
    entry::Begin(GL_POINTS);
    entry::TexCoord4f(1, 2, 3, 4);
    entry::Vertex4f(1, 2, 3, 4);
    entry::TexCoord2f(5, 6);
    entry::Vertex2f(7, 8);
    entry::End();
    const auto all = draws();
    CHECK(attribute(all[0], 1, Attribute::TexCoord0) == Value{5, 6, 0, 1});
    CHECK(position(all[0], 0) == Value{1, 2, 3, 4});
    CHECK(position(all[0], 1) == Value{7, 8, 0, 1});
}

TEST_CASE_METHOD(DrawFixture, "attributes of one to four components lie beside each other") {
    entry::Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
        const auto n = static_cast<float>(10 * i);
        entry::MultiTexCoord1f(GL_TEXTURE2, n + 1);
        if (i != 1) entry::MultiTexCoord2f(GL_TEXTURE1, n + 2, n + 3);
        entry::Normal3f(n + 4, n + 5, n + 6);
        entry::FogCoordf(n + 7);
        entry::MultiTexCoord4f(GL_TEXTURE0, n + 8, n + 9, n + 10, n + 11);
        entry::Vertex2f(n, -n);
    }
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(device.registers.vertex_format.stride == 2 + 3 + 1 + 4 + 2 + 1);
    for (unsigned i = 0; i < 3; ++i) {
        const auto n = static_cast<float>(10 * i), kept = i == 1 ? 0 : n;
        CHECK(position(all[0], i) == Value{n, -n, 0, 1});
        CHECK(attribute(all[0], i, Attribute::Normal) == Value{n + 4, n + 5, n + 6, 1});
        CHECK(attribute(all[0], i, Attribute::FogCoordinate) == Value{n + 7, 0, 0, 1});
        CHECK(attribute(all[0], i, Attribute::TexCoord0) == Value{n + 8, n + 9, n + 10, n + 11});
        CHECK(attribute(all[0], i, tex_coord(1)) == Value{kept + 2, kept + 3, 0, 1});
        CHECK(attribute(all[0], i, tex_coord(2)) == Value{n + 1, 0, 0, 1});
    }
}

TEST_CASE_METHOD(DrawFixture, "attributes set in a primitive are current after it") {
    entry::Begin(GL_POINTS);
    entry::Color3f(0.5f, 0, 1);
    entry::Normal3f(1, 0, 0);
    entry::MultiTexCoord2f(GL_TEXTURE3, 4, 5);
    entry::End();
    GLfloat values[4] = {};
    entry::GetFloatv(GL_CURRENT_COLOR, values);
    CHECK(values[2] == 1);
    entry::GetFloatv(GL_CURRENT_NORMAL, values);
    CHECK(values[0] == 1);
    entry::ActiveTexture(GL_TEXTURE3);
    entry::GetFloatv(GL_CURRENT_TEXTURE_COORDS, values);
    CHECK(values[1] == 5);
    CHECK(draws().empty());
}

TEST_CASE_METHOD(DrawFixture, "only the attributes that a primitive sets are in its vertices") {
    entry::Normal3f(0, 1, 0);
    entry::Color3f(1, 0, 0);
    entry::Begin(GL_POINTS);
    entry::TexCoord2f(0.5f, 0.25f);
    vertices(1);
    entry::End();
    const auto all = draws();
    CHECK(device.registers.vertex_format.stride == 5);
    CHECK(attribute(all[0], 0, Attribute::Color) == Value{1, 0, 0, 1});
    CHECK(attribute(all[0], 0, Attribute::Normal) == Value{0, 1, 0, 1});
}

TEST_CASE_METHOD(DrawFixture, "integers become floats as table 2.6 says") {
    const auto color = [&] { return gl.context().state.current.of(Attribute::Color); };
    const auto normal = [&] { return gl.context().state.current.of(Attribute::Normal); };
    entry::Color4ub(255, 0, 51, 255);
    CHECK(color() == Value{1, 0, 0.2f, 1});
    entry::Color3b(127, -128, 0);
    CHECK(color() == Value{1, -1, 1.0f / 255, 1});
    entry::Color3us(65535, 0, 13107);
    CHECK(color() == Value{1, 0, 0.2f, 1});
    entry::Color3ui(0xffffffffu, 0, 0);
    CHECK(color() == Value{1, 0, 0, 1});
    entry::Color3s(32767, -32768, 0);
    CHECK(color() == Value{1, -1, 1.0f / 65535, 1});
    entry::Normal3i(2147483647, -2147483647 - 1, 0);
    CHECK(normal()[0] == 1);
    CHECK(normal()[1] == -1);
    entry::TexCoord2s(-3, 7);
    CHECK(gl.context().state.current.of(Attribute::TexCoord0) == Value{-3, 7, 0, 1});
}

TEST_CASE_METHOD(DrawFixture, "a long strip is cut in two that draw the same triangles") {
    // More words than the assembler's buffer holds.
    constexpr int Count = 200001;
    entry::Begin(GL_TRIANGLE_STRIP);
    vertices(Count);
    entry::End();
    float next = 0;
    bool even = true;
    for (const DrawCommand& draw : draws()) {
        const std::vector<float> drawn = names(draw);
        CHECK(drawn[0] == next);
        even = even && static_cast<int>(next) % 2 == 0;
        // The next piece begins with this one's last two vertices.
        next = drawn.back() - 1;
    }
    CHECK(even); // Facing stays as it was.
    CHECK(next == Count - 2);
}

TEST_CASE_METHOD(DrawFixture, "a cut line loop is closed at its end") {
    entry::Begin(GL_LINE_LOOP);
    vertices(3);
    gl.context().immediate().cut();
    vertices(2, 3);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 2);
    CHECK(all[0].primitive == PrimitiveType::LineStrip);
    CHECK_FALSE(all[0].continue_line_stipple);
    CHECK(all[1].primitive == PrimitiveType::LineStrip);
    CHECK(all[1].continue_line_stipple);
    CHECK(names(all[1]) == std::vector<float>{2, 3, 4, 0});
}

TEST_CASE_METHOD(DrawFixture, "a cut line loop survives a change of the vertex format") {
    entry::Begin(GL_LINE_LOOP);
    vertices(3);
    gl.context().immediate().cut();
    entry::Color3f(1, 0, 0);
    vertices(2, 3);
    gl.context().immediate().cut();
    vertices(1, 5);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 3);
    CHECK(names(all[1]) == std::vector<float>{2, 3, 4});
    CHECK(names(all[2]) == std::vector<float>{4, 5, 0});
    CHECK(attribute(all[2], 2, Attribute::Color) == Value{1, 1, 1, 1});
}

TEST_CASE_METHOD(DrawFixture, "the cut through a polygon is not an edge of it") {
    entry::Begin(GL_POLYGON);
    vertices(4);
    gl.context().immediate().cut();
    vertices(2, 4);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 2);
    const auto flags = [&](const DrawCommand& draw) {
        std::vector<float> result;
        for (std::uint32_t i = 0; i < draw.count; ++i)
            result.push_back(attribute(draw, i, Attribute::EdgeFlag)[0]);
        return result;
    };
    CHECK(names(all[0]) == std::vector<float>{0, 1, 2, 3});
    CHECK(flags(all[0]) == std::vector<float>{1, 1, 1, 0});
    CHECK(names(all[1]) == std::vector<float>{0, 3, 4, 5});
    CHECK(flags(all[1]) == std::vector<float>{0, 1, 1, 1});
}

TEST_CASE_METHOD(DrawFixture, "a material that changes inside a primitive does not cut it") {
    const GLfloat red[] = {1, 0, 0, 1};
    entry::Begin(GL_TRIANGLE_FAN);
    vertices(3);
    entry::Materialfv(GL_FRONT, GL_DIFFUSE, red);
    vertices(2, 3);
    entry::End();
    CHECK(device.commands.empty());
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(names(all[0]) == std::vector<float>{0, 1, 2, 3, 4});
    CHECK(error() == GL_NO_ERROR);
}

TEST_CASE_METHOD(DrawFixture, "primitive restart ends a strip and begins another") {
    entry::Begin(GL_TRIANGLE_STRIP);
    vertices(3);
    entry::PrimitiveRestartNV();
    vertices(3, 3);
    entry::End();
    const auto all = draws();
    REQUIRE(all.size() == 2);
    CHECK(names(all[1]) == count_up(3, 3));
}

TEST_CASE_METHOD(DrawFixture, "glBegin and glEnd report their errors and change nothing") {
    entry::End();
    CHECK(error() == GL_INVALID_OPERATION);
    entry::Begin(GL_POLYGON + 1);
    CHECK(error() == GL_INVALID_ENUM);
    entry::Begin(GL_TRIANGLES);
    entry::Begin(GL_POINTS);
    vertices(3);
    entry::End();
    CHECK(error() == GL_INVALID_OPERATION);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(all[0].primitive == PrimitiveType::Triangles);
}

TEST_CASE_METHOD(DrawFixture, "commands other than a vertex's are errors between begin and end") {
    entry::Begin(GL_TRIANGLES);
    entry::PointSize(5);
    CHECK(entry::GenLists(1) == 0);
    CHECK(entry::GetError() == 0); // It fails as well.
    entry::End();
    CHECK(error() == GL_INVALID_OPERATION);
    CHECK(gl.context().state.rasterization.point.size == 1);
}

TEST_CASE_METHOD(DrawFixture, "vertices outside of begin and end draw nothing") {
    vertices(3);
    CHECK(draws().empty());
}

TEST_CASE_METHOD(DrawFixture, "a rectangle is a polygon of its four corners") {
    entry::Recti(1, 2, 3, 4);
    const auto all = draws();
    REQUIRE(all.size() == 1);
    CHECK(all[0].primitive == PrimitiveType::Polygon);
    CHECK(names(all[0]) == std::vector<float>{1, 3, 3, 1});
    CHECK(position(all[0], 2) == Value{3, 4, 0, 1});
}
