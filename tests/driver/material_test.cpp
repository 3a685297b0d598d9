#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <array>
#include <cmath>
#include <functional>
#include <vector>

#include <catch2/catch.hpp>

// glMaterial between glBegin and glEnd: each vertex has the material of its own time.

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

constexpr int Vertices = 12; // whole primitives of every type

struct LitFixture {
    LitFixture()
        : gpu({.threads = 1, .memory_bytes = 64u << 20})
        , gl(gpu, {.width = 64, .height = 64}) {
        gl.make_current();
        MatrixMode(GL_PROJECTION);
        Ortho(0, 64, 0, 64, 10, -10);
        MatrixMode(GL_MODELVIEW);
        Enable(GL_LIGHTING);
        Enable(GL_LIGHT0);
        Enable(GL_LIGHT1);
        const GLfloat ambient[]{0.1f, 0.2f, 0.15f, 1}, position[]{20, 30, 4, 1};
        const GLfloat specular[]{0.6f, 0.5f, 0.4f, 1};
        Lightfv(GL_LIGHT0, GL_AMBIENT, ambient);
        Lightfv(GL_LIGHT1, GL_POSITION, position);
        Lightfv(GL_LIGHT1, GL_DIFFUSE, specular);
        Lightfv(GL_LIGHT1, GL_SPECULAR, specular);
    }

    FunctionalGpu gpu;
    OffscreenContext gl;
};

// A value that differs from vertex to vertex.
float value(int i, int which) {
    return 0.5f + 0.45f * std::sin(static_cast<float>(i * 3 + which * 7));
}

void set_color(GLenum face, GLenum name, int i, int which) {
    const GLfloat color[]{value(i, which), value(i, which + 1), value(i, which + 2), 1};
    Materialfv(face, name, color);
}

struct Change {
    const char* name;
    std::function<void(int)> set; // the material of vertex i
};

const Change Changes[] = {
    {"a front colour", [](int i) { set_color(GL_FRONT, GL_DIFFUSE, i, 0); }},
    {"both colours", [](int i) { set_color(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, i, 0); }},
    {"a back colour", [](int i) { set_color(GL_BACK, GL_EMISSION, i, 0); }},
    {"at every third vertex", [](int i) { set_color(GL_FRONT_AND_BACK, GL_DIFFUSE, i / 3, 0); }},
    {"one change", [](int i) { set_color(GL_FRONT_AND_BACK, GL_DIFFUSE, i / 5, 0); }},
    {"the faces differ",
     [](int i) {
         set_color(GL_FRONT, GL_DIFFUSE, i, 0);
         set_color(GL_BACK, GL_DIFFUSE, i, 1);
     }},
    {"several colours",
     [](int i) {
         set_color(GL_FRONT_AND_BACK, GL_AMBIENT, i, 0);
         set_color(GL_FRONT_AND_BACK, GL_DIFFUSE, i, 1);
         set_color(GL_FRONT_AND_BACK, GL_SPECULAR, i, 2);
     }},
    {"shininess",
     [](int i) {
         const GLfloat white[]{1, 1, 1, 1};
         Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
         Materialf(GL_FRONT_AND_BACK, GL_SHININESS, static_cast<float>(i));
     }},
};

void vertex(int i) {
    // A strip that folds: some triangles face the viewer, others do not.
    const float x = 4 + 5 * static_cast<float>(i / 2) - (i / 2 == 3 ? 12.0f : 0.0f);
    Normal3f(value(i, 5) - 0.5f, value(i, 6) - 0.5f, 0.7f);
    Vertex3f(x, i % 2 == 0 ? 8.0f : 30.0f + static_cast<float>(i), value(i, 9));
}

// What feedback mode tells of what `draw` draws: positions and lit colours.
std::vector<GLfloat> feedback(const std::function<void()>& draw) {
    std::vector<GLfloat> buffer(4096);
    FeedbackBuffer(4096, GL_3D_COLOR, buffer.data());
    RenderMode(GL_FEEDBACK);
    draw();
    buffer.resize(static_cast<std::size_t>(RenderMode(GL_RENDER)));
    return buffer;
}

void primitive(GLenum mode, const std::function<void(int)>& set) {
    Begin(mode);
    for (int i = 0; i < Vertices; ++i) {
        set(i);
        vertex(i);
    }
    End();
}

// The same, put together of primitives whose vertices all have the material of one of them.
std::vector<GLfloat> expected_feedback(GLenum mode, const Change& change) {
    const auto uniform = [&](int i) {
        change.set(i);
        return feedback([&] { primitive(mode, [](int) {}); });
    };
    const std::vector<GLfloat> positions = feedback([] {
        Begin(GL_POINTS);
        for (int i = 0; i < Vertices; ++i)
            vertex(i);
        End();
    });
    std::vector<std::vector<GLfloat>> all;
    for (int i = 0; i < Vertices; ++i)
        all.push_back(uniform(i));
    std::vector<GLfloat> result = all[0];
    for (std::size_t at = 0; at < result.size();) {
        const auto token = static_cast<GLenum>(result[at++]);
        const bool is_line = token == GL_LINE_TOKEN || token == GL_LINE_RESET_TOKEN;
        std::size_t n = is_line ? 2 : 1;
        if (token == GL_POLYGON_TOKEN) n = static_cast<std::size_t>(result[at++]);
        for (; n-- > 0; at += 7) {
            for (std::size_t i = 0; i < Vertices; ++i) {
                const auto* const position = positions.data() + 8 * i + 1;
                if (!std::equal(position, position + 3, result.data() + at)) continue;
                std::copy_n(all[i].data() + at, 7, result.data() + at);
            }
        }
    }
    return result;
}

void check_close(const std::vector<GLfloat>& found, const std::vector<GLfloat>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        INFO("token " << i);
        REQUIRE(found[i] == Approx(expected[i]).margin(2e-5));
    }
}

void check_every_primitive(const Change& change) {
    for (GLenum mode = GL_POINTS; mode <= GL_POLYGON; ++mode) {
        INFO("mode " << mode);
        const std::vector<GLfloat> expected = expected_feedback(mode, change);
        check_close(feedback([&] { primitive(mode, change.set); }), expected);

        NewList(1, GL_COMPILE);
        primitive(mode, change.set);
        EndList();
        check_close(feedback([] { CallList(1); }), expected);

        // Merged with primitives before and behind it.
        std::vector<GLfloat> three = expected;
        three.insert(three.end(), expected.begin(), expected.end());
        three.insert(three.end(), expected.begin(), expected.end());
        check_close(feedback([&] {
                        for (int i = 0; i < 3; ++i)
                            primitive(mode, change.set);
                    }),
                    three);
    }
}

} // namespace

TEST_CASE_METHOD(LitFixture, "each vertex is lit with the material of its time") {
    for (const Change& change : Changes) {
        INFO(change.name);
        check_every_primitive(change);
    }
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(LitFixture, "each vertex is lit with the material of its time, on both sides") {
    LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    for (const Change& change : Changes) {
        INFO(change.name);
        check_every_primitive(change);
    }
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(LitFixture, "materials change while another colour is the vertex's") {
    LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    ColorMaterial(GL_FRONT, GL_AMBIENT);
    Enable(GL_COLOR_MATERIAL);
    check_every_primitive({"tracked", [](int i) {
                               set_color(GL_FRONT_AND_BACK, GL_DIFFUSE, i, 0);
                               // In the reference run the colour is current for every vertex.
                               Color3f(value(i, 1), value(i, 2), value(i, 3));
                           }});
}

TEST_CASE_METHOD(LitFixture, "culled faces stay culled where the vertices are lit apart") {
    LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    for (const GLenum face : std::array<GLenum, 3>{GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) {
        Enable(GL_CULL_FACE);
        CullFace(face);
        check_every_primitive(Changes[6]);
    }
}

TEST_CASE_METHOD(LitFixture, "edges of strips are drawn whatever their flags") {
    LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
    entry::PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    EdgeFlag(0);
    check_every_primitive(Changes[5]);
    check_every_primitive(Changes[6]);
}

TEST_CASE_METHOD(LitFixture, "a primitive that outgrows the buffer keeps its vertices' materials") {
    const auto loop = [](bool marks) {
        constexpr int Count = 200'000; // more than one draw takes
        set_color(GL_FRONT, GL_DIFFUSE, 1, 0);
        Begin(GL_LINE_LOOP);
        for (int i = 0; i < Count; ++i) {
            if (marks && i % 1000 == 1) set_color(GL_FRONT, GL_DIFFUSE, i, 0);
            vertex(i == 0 ? 2 : 4);
        }
        End();
    };
    const auto end_of = [&](bool marks) {
        std::vector<GLfloat> buffer(200'000 * 15 + 64);
        FeedbackBuffer(static_cast<GLsizei>(buffer.size()), GL_3D_COLOR, buffer.data());
        RenderMode(GL_FEEDBACK);
        loop(marks);
        buffer.resize(static_cast<std::size_t>(RenderMode(GL_RENDER)));
        return std::vector<GLfloat>(buffer.end() - 7, buffer.end());
    };
    // The line that closes the loop ends at the first vertex, with its material.
    check_close(end_of(true), end_of(false));
}

TEST_CASE_METHOD(LitFixture, "the secondary colour follows the vertex's material") {
    LightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
    ShadeModel(GL_FLAT);
    const auto material = [](int i) {
        set_color(GL_FRONT, GL_DIFFUSE, i, 0);
        set_color(GL_FRONT, GL_SPECULAR, i, 1);
    };
    const auto pixel = [] {
        std::array<GLubyte, 4> color{};
        ReadPixels(20, 20, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, color.data());
        return color;
    };
    const auto triangle = [&](bool inside) {
        Clear(GL_COLOR_BUFFER_BIT);
        if (!inside) material(2);
        Begin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) {
            if (inside) material(i);
            Normal3f(0.1f, 0.2f, 0.9f);
            Vertex2f(i == 0 ? 60.0f : 4.0f, i == 1 ? 60.0f : 4.0f);
        }
        End();
        return pixel();
    };
    // Flat: the colour of the last vertex.
    const auto expected = triangle(false);
    const auto found = triangle(true);
    for (std::size_t c = 0; c < 4; ++c)
        CHECK(std::abs(int{found[c]} - int{expected[c]}) <= 1);
    material(0);
    CHECK(triangle(false) != std::array<GLubyte, 4>{});
    CHECK(GetError() == 0);
}
