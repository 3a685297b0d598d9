#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
namespace entry = ffgpu::gl::entry;

namespace {

// 64 x 64 pixels on the functional GPU; object coordinates are pixels, z from -1 (near) to 1.
struct PixelFixture {
    PixelFixture()
        : gpu({.threads = 1, .memory_bytes = 64u << 20})
        , gl(gpu, {.width = 64, .height = 64}) {
        gl.make_current();
        entry::MatrixMode(GL_PROJECTION);
        entry::Ortho(0, 64, 0, 64, 1, -1);
        entry::MatrixMode(GL_MODELVIEW);
    }

    static void triangle(float x, float z = 0) {
        entry::Begin(GL_TRIANGLES);
        entry::Vertex3f(x, 1, z);
        entry::Vertex3f(x + 8, 1, z);
        entry::Vertex3f(x, 9, z);
        entry::End();
    }

    FunctionalGpu gpu;
    OffscreenContext gl;
};

} // namespace

TEST_CASE_METHOD(PixelFixture, "feedback returns the vertices of what would be drawn") {
    GLfloat buffer[64] = {};
    entry::FeedbackBuffer(64, GL_3D_COLOR, buffer);
    CHECK(entry::RenderMode(GL_FEEDBACK) == 0);
    entry::Color4f(1, 0.5f, 0, 1);
    entry::PassThrough(42);
    triangle(4);
    const GLint count = entry::RenderMode(GL_RENDER);
    REQUIRE(count == 2 + 2 + 3 * 7);
    CHECK(buffer[0] == GL_PASS_THROUGH_TOKEN);
    CHECK(buffer[1] == 42);
    CHECK(buffer[2] == GL_POLYGON_TOKEN);
    CHECK(buffer[3] == 3);
    CHECK(buffer[4] == 4);
    CHECK(buffer[5] == 1);
    CHECK(buffer[6] == 0.5f);
    CHECK(buffer[7] == 1);
    CHECK(buffer[8] == Approx(0.5f).margin(0.003));
    CHECK(buffer[11] == 12);
    CHECK(entry::GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(PixelFixture, "feedback of a polygon in line mode is its lines") {
    std::vector<GLfloat> buffer(64);
    entry::FeedbackBuffer(64, GL_2D, buffer.data());
    entry::RenderMode(GL_FEEDBACK);
    entry::PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    triangle(4);
    CHECK(entry::RenderMode(GL_RENDER) == 15);
    CHECK((buffer[0] == GL_LINE_RESET_TOKEN || buffer[0] == GL_LINE_TOKEN));
    CHECK(buffer[5] == GL_LINE_TOKEN);
}

TEST_CASE_METHOD(PixelFixture, "feedback that does not fit says so and writes no further") {
    GLfloat buffer[6] = {0, 0, 0, 0, 0, -7};
    entry::FeedbackBuffer(5, GL_2D, buffer);
    entry::RenderMode(GL_FEEDBACK);
    triangle(4);
    CHECK(entry::RenderMode(GL_RENDER) == -1);
    CHECK(buffer[5] == -7);
}

TEST_CASE_METHOD(PixelFixture, "feedback of many primitives outgrows the device's first buffer") {
    std::vector<GLfloat> buffer(100000);
    entry::FeedbackBuffer(100000, GL_2D, buffer.data());
    entry::RenderMode(GL_FEEDBACK);
    for (int i = 0; i < 4000; ++i)
        triangle(4);
    CHECK(entry::RenderMode(GL_RENDER) == 4000 * 8);
}

TEST_CASE_METHOD(PixelFixture, "selection writes a record for each name that was hit") {
    GLuint buffer[64] = {};
    entry::SelectBuffer(64, buffer);
    entry::RenderMode(GL_SELECT);
    entry::InitNames();
    entry::PushName(7);
    triangle(4, -1);
    entry::LoadName(8); // Outside of the window: no hit.
    triangle(100);
    entry::PushName(9);
    triangle(4, 0);
    triangle(4, 1);
    REQUIRE(entry::RenderMode(GL_RENDER) == 2);
    CHECK(buffer[0] == 1);
    CHECK(buffer[1] == 0);
    CHECK(buffer[2] == 0);
    CHECK(buffer[3] == 7);
    CHECK(buffer[4] == 2);
    CHECK(buffer[5] == Approx(0.5 * 4294967295.0).epsilon(1e-6));
    CHECK(buffer[6] == 0xffffffffu);
    CHECK(buffer[7] == 8);
    CHECK(buffer[8] == 9);
}

TEST_CASE_METHOD(PixelFixture, "nothing is drawn in selection mode") {
    GLuint buffer[8] = {};
    entry::Clear(GL_COLOR_BUFFER_BIT);
    entry::SelectBuffer(8, buffer);
    entry::RenderMode(GL_SELECT);
    entry::Rectf(0, 0, 64, 64);
    CHECK(entry::RenderMode(GL_RENDER) == 1);
    GLubyte pixel[4] = {};
    entry::ReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 0);
    entry::Rectf(0, 0, 64, 64);
    entry::ReadPixels(5, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    CHECK(pixel[0] == 255);
}

TEST_CASE_METHOD(PixelFixture, "selection and feedback report their errors") {
    GLuint names[4];
    CHECK(entry::RenderMode(GL_SELECT) == 0);
    CHECK(entry::GetError() == GL_INVALID_OPERATION); // There is no buffer.
    entry::RenderMode(GL_LINE);
    CHECK(entry::GetError() == GL_INVALID_ENUM);
    entry::SelectBuffer(-1, names);
    CHECK(entry::GetError() == GL_INVALID_VALUE);
    entry::FeedbackBuffer(4, GL_RGBA, nullptr);
    CHECK(entry::GetError() == GL_INVALID_ENUM);
    entry::PopName(); // Ignored: not in selection mode.
    CHECK(entry::GetError() == GL_NO_ERROR);
    entry::SelectBuffer(4, names);
    entry::RenderMode(GL_SELECT);
    entry::SelectBuffer(4, names);
    CHECK(entry::GetError() == GL_INVALID_OPERATION);
    entry::LoadName(1);
    CHECK(entry::GetError() == GL_INVALID_OPERATION);
    entry::PopName();
    CHECK(entry::GetError() == GL_STACK_UNDERFLOW);
    for (int i = 0; i < 64; ++i)
        entry::PushName(1);
    CHECK(entry::GetError() == GL_NO_ERROR);
    entry::PushName(1);
    CHECK(entry::GetError() == GL_STACK_OVERFLOW);
}

TEST_CASE_METHOD(PixelFixture, "the raster position is a transformed and lit vertex") {
    entry::Translatef(10, 20, 0);
    entry::Color3f(0.5f, 0, 0);
    entry::RasterPos3f(1, 2, 1);
    GLfloat position[4] = {};
    entry::GetFloatv(GL_CURRENT_RASTER_POSITION, position);
    CHECK(position[0] == Approx(11));
    CHECK(position[1] == Approx(22));
    CHECK(position[2] == Approx(1));
    CHECK(position[3] == 1);
    GLfloat color[4] = {};
    entry::GetFloatv(GL_CURRENT_RASTER_COLOR, color);
    CHECK(color[0] == 0.5f);

    entry::Enable(GL_LIGHTING); // Scene ambient 0.2 on ambient material 0.2.
    entry::RasterPos2f(0, 0);
    entry::GetFloatv(GL_CURRENT_RASTER_COLOR, color);
    CHECK(color[0] == Approx(0.04f));
    CHECK(color[3] == 1);
}

TEST_CASE_METHOD(PixelFixture, "a raster position that is clipped is not valid") {
    GLboolean valid = GL_TRUE;
    entry::RasterPos2f(-1, 5);
    entry::GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    CHECK_FALSE(valid);
    entry::RasterPos3f(1, 5, 3);
    entry::GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    CHECK_FALSE(valid);
    entry::Enable(GL_DEPTH_CLAMP); // No near and far plane.
    entry::RasterPos3f(1, 5, 3);
    GLfloat clamped[4] = {};
    entry::GetFloatv(GL_CURRENT_RASTER_POSITION, clamped);
    CHECK(clamped[2] == 1);
    entry::WindowPos3f(-1, 70, 2);
    entry::GetBooleanv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
    CHECK(valid);
    GLfloat position[4] = {};
    entry::GetFloatv(GL_CURRENT_RASTER_POSITION, position);
    CHECK(position[0] == -1);
    CHECK(position[2] == 1);
}

TEST_CASE_METHOD(PixelFixture, "the raster position's lighting is the device's") {
    // The same vertex by feedback: colours of the geometry stage.
    const GLfloat position[] = {20, 60, -30, 1};
    const GLfloat white[] = {1, 1, 1, 1};
    entry::Enable(GL_LIGHTING);
    entry::Enable(GL_LIGHT0);
    entry::Lightfv(GL_LIGHT0, GL_POSITION, position);
    entry::Lightf(GL_LIGHT0, GL_LINEAR_ATTENUATION, 0.01f);
    entry::Materialfv(GL_FRONT, GL_SPECULAR, white);
    entry::Materialf(GL_FRONT, GL_SHININESS, 3);
    entry::LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE);
    entry::Normal3f(0.6f, 0, 0.8f);
    entry::Normal3f(0, 0.6f, -0.8f);
    GLfloat buffer[16] = {};
    entry::FeedbackBuffer(16, GL_3D_COLOR, buffer);
    entry::RenderMode(GL_FEEDBACK);
    entry::Begin(GL_POINTS);
    entry::Vertex3f(10, 30, 0.25f);
    entry::End();
    REQUIRE(entry::RenderMode(GL_RENDER) == 8);
    entry::RasterPos3f(10, 30, 0.25f);
    GLfloat raster[4] = {}, color[4] = {};
    entry::GetFloatv(GL_CURRENT_RASTER_POSITION, raster);
    entry::GetFloatv(GL_CURRENT_RASTER_COLOR, color);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(raster[i] == Approx(buffer[1 + i]));
        CHECK(color[i] == Approx(buffer[4 + i]).margin(0.006));
    }
    CHECK(color[0] > 0.1f);
}
