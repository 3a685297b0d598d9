// What a swap leaves in the back buffer, and when it costs a copy.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"
#include "tests/driver/state_fixture.h"

#include <string>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

constexpr GLsizei Columns = 6;

// Draws frames of one white column each, without a clear, and tells what the buffer then shows:
// '#' where a column is.
struct Trails {
    explicit Trails(PixelFormat format = {})
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = Columns, .height = 4, .format = format}) {
        gl.make_current();
    }

    void draw_column(GLint column) {
        Enable(GL_SCISSOR_TEST);
        entry::Scissor(column, 0, 1, 4);
        ClearColor(1, 1, 1, 1);
        Clear(GL_COLOR_BUFFER_BIT);
        Disable(GL_SCISSOR_TEST);
    }
    void swap(SwapMode mode) {
        Flush();
        gl.drawable().swap(mode);
    }
    static std::string columns(GLenum buffer) {
        std::vector<GLubyte> red(Columns);
        ReadBuffer(buffer);
        ReadPixels(0, 1, Columns, 1, GL_RED, GL_UNSIGNED_BYTE, red.data());
        std::string text;
        for (const GLubyte value : red)
            text += value == 0 ? '.' : '#';
        return text;
    }

    FunctionalGpu device;
    OffscreenContext gl;
};

struct CountsCopies : StateFixture {
    CountsCopies() { device.forget(); }

    // That the device was told to make since the last call.
    std::size_t copies() {
        std::size_t count = 0;
        for (const auto& command : device.commands)
            count += command.opcode == Opcode::CopyRectangle;
        device.forget();
        return count;
    }
    void swap() { gl.drawable().swap(SwapMode::Copy); }
};

} // namespace

TEST_CASE("a swap that copies keeps the picture that is drawn over") {
    for (const std::uint8_t samples : {std::uint8_t{1}, std::uint8_t{4}}) {
        Trails trails({.samples = samples});
        for (GLint frame = 0; frame < 4; ++frame) {
            trails.draw_column(frame);
            trails.swap(SwapMode::Copy);
        }
        CHECK(Trails::columns(GL_FRONT) == "####..");
        CHECK(Trails::columns(GL_BACK) == "####..");
        trails.draw_column(5);
        CHECK(Trails::columns(GL_FRONT) == "####..");
        CHECK(Trails::columns(GL_BACK) == "####.#");
    }
}

TEST_CASE("a swap that exchanges gives back the picture before the last") {
    Trails trails;
    for (GLint frame = 0; frame < 4; ++frame) {
        trails.draw_column(frame);
        trails.swap(SwapMode::Exchange);
    }
    CHECK(Trails::columns(GL_FRONT) == ".#.#..");
    CHECK(Trails::columns(GL_BACK) == "#.#...");
}

TEST_CASE("swaps without drawing between them show the same picture") {
    Trails trails;
    trails.draw_column(2);
    for (int i = 0; i < 3; ++i) {
        trails.swap(SwapMode::Copy);
        CHECK(trails.columns(GL_FRONT) == "..#...");
    }
    trails.swap(SwapMode::Copy);
    trails.swap(SwapMode::Copy);
    CHECK(trails.columns(GL_BACK) == "..#...");
}

TEST_CASE("what is drawn to the front buffer after a swap is not in the back buffer") {
    Trails trails;
    trails.draw_column(0);
    trails.swap(SwapMode::Copy);
    DrawBuffer(GL_FRONT);
    trails.draw_column(3);
    CHECK(Trails::columns(GL_BACK) == "#.....");
    CHECK(Trails::columns(GL_FRONT) == "#..#..");
}

TEST_CASE("a new size after a swap keeps both pictures") {
    Trails trails;
    trails.draw_column(1);
    trails.swap(SwapMode::Copy);
    trails.gl.drawable().resize(Columns + 3, 9);
    CHECK(Trails::columns(GL_BACK) == ".#....");
    CHECK(Trails::columns(GL_FRONT) == ".#....");
}

TEST_CASE("a frame that begins with a clear costs no copy") {
    CountsCopies f;
    for (int frame = 0; frame < 3; ++frame) {
        Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        Rectf(-1, -1, 1, 1);
        Flush();
        f.swap();
    }
    CHECK(f.copies() == 0);
}

TEST_CASE("what is drawn elsewhere before the clear costs no copy") {
    CountsCopies f;
    GLuint framebuffer = 0, renderbuffer = 0;
    GenFramebuffers(1, &framebuffer);
    GenRenderbuffers(1, &renderbuffer);
    BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
    RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA, 4, 4);
    f.swap();
    BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, renderbuffer);
    Rectf(-1, -1, 1, 1);
    CHECK(f.copies() == 0);
    BindFramebuffer(GL_FRAMEBUFFER, 0);
    Clear(GL_COLOR_BUFFER_BIT);
    CHECK(f.copies() == 0);
    Rectf(-1, -1, 1, 1);
    f.swap();
    Rectf(-1, -1, 1, 1);
    CHECK(f.copies() == 1);
}

TEST_CASE("what leaves a part of the back buffer as it was costs one copy") {
    CountsCopies f;
    const auto copies_of = [&f](auto&& begin_frame) {
        f.swap();
        f.copies();
        begin_frame();
        Clear(GL_COLOR_BUFFER_BIT);
        return f.copies();
    };
    CHECK(copies_of([] {}) == 0);
    CHECK(copies_of([] { Rectf(-1, -1, 1, 1); }) == 1);
    CHECK(copies_of([] { Clear(GL_DEPTH_BUFFER_BIT); }) == 1);
    CHECK(copies_of([] {
              Enable(GL_SCISSOR_TEST);
              entry::Scissor(0, 0, 1 << 14, 1 << 14);
          }) == 0);
    CHECK(copies_of([] { entry::Scissor(1, 0, 1 << 14, 1 << 14); }) == 1);
    Disable(GL_SCISSOR_TEST);
    CHECK(copies_of([] { ColorMask(1, 1, 1, 0); }) == 1);
    ColorMask(1, 1, 1, 1);
    CHECK(copies_of([] { DrawBuffer(GL_FRONT_AND_BACK); }) == 1);
    CHECK(copies_of([] { DrawBuffer(GL_FRONT); }) == 1);
    CHECK(copies_of([] { DrawBuffer(GL_NONE); }) == 1);
    DrawBuffer(GL_BACK);
    CHECK(copies_of([] {
              GLubyte pixel[4];
              ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
          }) == 1);
}
