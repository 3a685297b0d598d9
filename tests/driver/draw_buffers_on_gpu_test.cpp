// Several draw buffers on the functional GPU (ARB_draw_buffers): each is blended, masked, cleared
// and blitted to with what it holds itself.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <array>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

constexpr GLsizei Size = 16;
using Pixel = std::array<GLubyte, 4>;

struct Buffers {
    Buffers()
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = Size, .height = Size}) {
        gl.make_current();
    }

    static void fill(GLenum buffer, float red, float green) {
        DrawBuffer(buffer);
        ClearColor(red, green, 0, 1);
        Clear(GL_COLOR_BUFFER_BIT);
    }
    static void add(float red, float green) {
        Enable(GL_BLEND);
        BlendFunc(GL_ONE, GL_ONE);
        Color3f(red, green, 0);
        Rectf(-1, -1, 1, 1);
        Disable(GL_BLEND);
    }
    static Pixel read(GLenum buffer) {
        Pixel pixel{};
        ReadBuffer(buffer);
        ReadPixels(7, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
        return pixel;
    }

    FunctionalGpu device;
    OffscreenContext gl;
};

struct AttachedBuffers : Buffers {
    AttachedBuffers() {
        GLuint framebuffer = 0;
        GenFramebuffers(1, &framebuffer);
        BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        for (GLenum i = 0; i < 8; ++i) {
            GLuint name = 0;
            GenRenderbuffers(1, &name);
            BindRenderbuffer(GL_RENDERBUFFER, name);
            RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, Size, Size);
            FramebufferRenderbuffer(
                GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_RENDERBUFFER, name);
            all.push_back(GL_COLOR_ATTACHMENT0 + i);
            fill(GL_COLOR_ATTACHMENT0 + i, static_cast<float>(i) / 255, 0);
        }
        DrawBuffers(8, all.data());
    }

    std::vector<GLenum> all;
};

} // namespace

TEST_CASE_METHOD(Buffers, "front and back are blended each with its own content") {
    fill(GL_FRONT, 0.2f, 0);
    fill(GL_BACK, 0, 0.4f);
    DrawBuffer(GL_FRONT_AND_BACK);
    add(0.2f, 0.2f);
    CHECK(read(GL_FRONT) == Pixel{102, 51, 0, 255});
    CHECK(read(GL_BACK) == Pixel{51, 153, 0, 255});
    const GLenum buffers[] = {GL_NONE, GL_BACK_LEFT, GL_FRONT_LEFT};
    DrawBuffers(3, buffers);
    add(0.2f, 0);
    CHECK(read(GL_FRONT) == Pixel{153, 51, 0, 255});
    CHECK(read(GL_BACK) == Pixel{102, 153, 0, 255});
}

TEST_CASE_METHOD(AttachedBuffers, "eight attachments are blended each with its own content") {
    add(0.2f, 0.4f);
    for (GLubyte i = 0; i < 8; ++i)
        CHECK(read(all[i]) == Pixel{static_cast<GLubyte>(51 + i), 102, 0, 255});
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(AttachedBuffers, "masks, clears and blits go to the buffers that are selected") {
    const std::array<GLenum, 3> some{all[6], GL_NONE, all[1]};
    DrawBuffers(3, some.data());
    ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    ClearColor(1, 1, 0, 1);
    Clear(GL_COLOR_BUFFER_BIT);
    ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (GLubyte i = 0; i < 8; ++i) {
        const bool selected = i == 6 || i == 1;
        CHECK(read(all[i]) == Pixel{selected ? GLubyte{255} : i, 0, 0, 255});
    }
    ReadBuffer(all[5]);
    BlitFramebuffer(0, 0, Size, Size, 0, 0, Size, Size, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    CHECK(read(all[6])[0] == 5);
    CHECK(read(all[1])[0] == 5);
    CHECK(read(all[2])[0] == 2);
}
