// Framebuffer objects: completeness, where their surfaces lie, queries, blits.

#include "driver/images/blit.h"
#include "driver/objects/framebuffer_object.h"
#include "tests/driver/state_fixture.h"

#include <cstring>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

struct FramebufferFixture : StateFixture {
    FramebufferFixture() {
        GenFramebuffers(1, &framebuffer);
        BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        GenTextures(1, &texture);
        BindTexture(GL_TEXTURE_2D, texture);
    }

    static void define(GLint level, GLint internal, GLsizei width, GLsizei height) {
        TexImage2D(
            GL_TEXTURE_2D, level, internal, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    }
    void attach(GLenum point, GLint level = 0) const {
        FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, level);
    }
    static GLuint attach_renderbuffer(GLenum point, GLenum internal, GLsizei size) {
        GLuint name = 0;
        GenRenderbuffers(1, &name);
        BindRenderbuffer(GL_RENDERBUFFER, name);
        RenderbufferStorage(GL_RENDERBUFFER, internal, size, size);
        FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
        return name;
    }
    static GLenum status() { return CheckFramebufferStatus(GL_FRAMEBUFFER); }
    static GLint attachment_value(GLenum point, GLenum name) {
        GLint value = -1;
        GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, point, name, &value);
        return value;
    }

    GLuint framebuffer = 0, texture = 0;
};

} // namespace

TEST_CASE_METHOD(FramebufferFixture, "completeness names what is wrong") {
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
    attach(GL_COLOR_ATTACHMENT0);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT); // No image.
    define(0, GL_RGBA, 16, 8);
    CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    attach(GL_COLOR_ATTACHMENT0, 1);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
    attach(GL_COLOR_ATTACHMENT0);
    DrawBuffer(GL_COLOR_ATTACHMENT1);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER);
    DrawBuffer(GL_NONE);
    CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    ReadBuffer(GL_COLOR_ATTACHMENT1);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER);
    ReadBuffer(GL_NONE);
    for (const GLint compressed : {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGB_FXT1_3DFX}) {
        define(0, compressed, 16, 8);
        CHECK(status() == GL_FRAMEBUFFER_UNSUPPORTED);
    }
    for (const GLint format : {GL_LUMINANCE, GL_ALPHA, GL_RGBA4, GL_RGB5_A1, GL_RGB5}) {
        define(0, format, 16, 8);
        CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    }
    attach(GL_DEPTH_ATTACHMENT); // A colour texture.
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
}

TEST_CASE_METHOD(FramebufferFixture, "each draw buffer is a target and must be attached") {
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 16);
    attach_renderbuffer(GL_COLOR_ATTACHMENT5, GL_RGBA8, 8);
    const GLenum buffers[] = {GL_COLOR_ATTACHMENT5, GL_NONE, GL_COLOR_ATTACHMENT0};
    DrawBuffers(3, buffers);
    CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    const auto sizes = [this] {
        std::vector<int> all;
        for (const Surface& target : drawn().targets.color)
            all.push_back(target.width);
        return all;
    };
    CHECK(sizes() == std::vector{8, 0, 16, 0, 0, 0, 0, 0});
    CHECK(drawn().scissor.width == 8); // what both have
    CHECK(get_int(GL_DRAW_BUFFER) == GL_COLOR_ATTACHMENT5);
    CHECK(get_int(GL_DRAW_BUFFER1) == GL_NONE);
    CHECK(get_int(GL_DRAW_BUFFER2) == GL_COLOR_ATTACHMENT0);

    PushAttrib(GL_COLOR_BUFFER_BIT);
    DrawBuffer(GL_COLOR_ATTACHMENT0); // The others are off.
    CHECK(sizes() == std::vector{16, 0, 0, 0, 0, 0, 0, 0});
    PopAttrib();
    CHECK(sizes() == std::vector{8, 0, 16, 0, 0, 0, 0, 0});

    FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, 0);
    CHECK(status() == GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER);
    const GLenum none = GL_NONE;
    DrawBuffers(1, &none);
    CHECK(sizes() == std::vector(8, 0));

    BindFramebuffer(GL_FRAMEBUFFER, 0); // The window has its own.
    CHECK(get_int(GL_DRAW_BUFFER) == GL_BACK);
    CHECK(get_int(GL_DRAW_BUFFER2) == GL_NONE);
}

TEST_CASE_METHOD(FramebufferFixture, "what a framebuffer object draws to survives a pop at NONE") {
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 16);
    PushAttrib(GL_COLOR_BUFFER_BIT | GL_PIXEL_MODE_BIT);
    DrawBuffer(GL_NONE);
    ReadBuffer(GL_NONE);
    PopAttrib();
    CHECK(get_int(GL_DRAW_BUFFER) == GL_COLOR_ATTACHMENT0);
    CHECK(get_int(GL_READ_BUFFER) == GL_COLOR_ATTACHMENT0);
}

TEST_CASE_METHOD(FramebufferFixture, "drawing goes to the texture's own memory") {
    define(0, GL_RGBA, 16, 8);
    define(1, GL_RGBA, 8, 4);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
    attach(GL_COLOR_ATTACHMENT0, 1);
    Enable(GL_TEXTURE_2D);
    const Registers& registers = drawn();
    CHECK(registers.targets.color[0].format == Format::Rgba8);
    CHECK(registers.targets.color[0].width == 8);
    CHECK(registers.targets.color[0].stride == 32);
    CHECK(registers.targets.color[0].address == registers.images[0].address + 16 * 8 * 4);
    CHECK(registers.scissor.width == 8);
    // The texture grows by a level and moves; the target moves with it.
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 2);
    define(2, GL_RGBA, 4, 2);
    drawn();
    CHECK(registers.targets.color[0].address == registers.images[0].address + 16 * 8 * 4);
    CHECK(registers.images[0].shape.levels == 3);
    BindFramebuffer(GL_FRAMEBUFFER, 0);
    CHECK(drawn().targets.color[0] == gl.drawable().back());
}

TEST_CASE_METHOD(FramebufferFixture, "packed depth and stencil are one surface with two meanings") {
    attach_renderbuffer(GL_COLOR_ATTACHMENT0, GL_RGBA8, 16);
    const GLuint packed = attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH24_STENCIL8, 16);
    CHECK(status() == GL_FRAMEBUFFER_COMPLETE);
    CHECK(drawn().targets.depth.format == Format::Depth24Stencil8);
    Enable(GL_STENCIL_TEST);
    CHECK_FALSE(drawn().stencil.enable); // Its stencil bits are not attached.
    FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_RENDERBUFFER, packed);
    CHECK(drawn().stencil.enable);
    attach_renderbuffer(GL_STENCIL_ATTACHMENT, GL_STENCIL_INDEX8, 16);
    CHECK(status() == GL_FRAMEBUFFER_UNSUPPORTED);
}

TEST_CASE_METHOD(FramebufferFixture, "attachments answer queries and vanish with their objects") {
    define(0, GL_RGB, 4, 4);
    attach(GL_COLOR_ATTACHMENT0);
    CHECK(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) ==
          GL_TEXTURE);
    CHECK(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME) ==
          static_cast<GLint>(texture));
    CHECK(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_GREEN_SIZE) == 8);
    DeleteTextures(1, &texture);
    CHECK(attachment_value(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE);
    const GLuint buffer = attach_renderbuffer(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT16, 4);
    GLint bits = 0;
    GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_DEPTH_SIZE, &bits);
    CHECK(bits == 16);
    DeleteRenderbuffers(1, &buffer);
    CHECK(attachment_value(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) == GL_NONE);
    DeleteFramebuffers(1, &framebuffer);
    CHECK(get_int(GL_FRAMEBUFFER_BINDING) == 0);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(FramebufferFixture,
                 "wrong arguments of framebuffer commands are the specified errors") {
    FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_3D, texture, 0);
    CHECK(GetError() == GL_INVALID_OPERATION);
    define(0, GL_RGBA, 4, 4);
    attach(GL_COLOR_ATTACHMENT0, -1);
    CHECK(GetError() == GL_INVALID_VALUE);
    attach(GL_TEXTURE_2D);
    CHECK(GetError() == GL_INVALID_ENUM);
    FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 999, 0);
    CHECK(GetError() == GL_INVALID_OPERATION);
    BindFramebuffer(GL_FRAMEBUFFER, 999); // A name that was not generated.
    CHECK(GetError() == GL_INVALID_OPERATION);
    RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 4, 4); // None is bound.
    CHECK(GetError() == GL_INVALID_OPERATION);
    RenderbufferStorage(GL_RENDERBUFFER, GL_COLOR_INDEX, 4, 4);
    CHECK(GetError() == GL_INVALID_ENUM);
    RenderbufferStorage(GL_RENDERBUFFER, GL_COMPRESSED_RGB, 4, 4);
    CHECK(GetError() == GL_INVALID_ENUM);
    BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    CHECK(GetError() == GL_INVALID_FRAMEBUFFER_OPERATION);
    BindFramebuffer(GL_FRAMEBUFFER, 0);
    attach(GL_COLOR_ATTACHMENT0);
    CHECK(GetError() == GL_INVALID_OPERATION);
    BlitFramebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_DEPTH_BUFFER_BIT, GL_LINEAR);
    CHECK(GetError() == GL_INVALID_OPERATION);
}

namespace {

// Two rows of pixels whose red channel is given, on a device of their own.
struct BlitFixture {
    RecordingDevice device{4096};
    Surface from{.address = 0, .format = Format::Rgba8, .width = 4, .height = 1, .stride = 16};
    Surface to{.address = 1024, .format = Format::Rgba8, .width = 8, .height = 1, .stride = 32};

    BlitFixture() {
        for (std::size_t x = 0; x < 4; ++x)
            device.memory[4 * x] = static_cast<std::byte>(40 * x);
    }
    std::vector<unsigned> blitted(const BlitAxis& x, bool linear) {
        blit_colors(
            device, from, to, {.x = x, .y = {0, 1, 0, 1}, .linear = linear, .clip = {0, 0, 8, 1}});
        std::vector<unsigned> reds;
        for (std::size_t i = 0; i < 8; ++i)
            reds.push_back(std::to_integer<unsigned>(device.memory[1024 + 4 * i]));
        return reds;
    }
};

} // namespace

TEST_CASE_METHOD(BlitFixture, "a blit scales, mirrors and leaves out what has no source") {
    CHECK(blitted({0, 4, 0, 8}, false) == std::vector<unsigned>{0, 0, 40, 40, 80, 80, 120, 120});
    CHECK(blitted({0, 4, 8, 0}, false) == std::vector<unsigned>{120, 120, 80, 80, 40, 40, 0, 0});
    CHECK(blitted({0, 4, 0, 8}, true) == std::vector<unsigned>{0, 10, 30, 50, 70, 90, 110, 120});
    std::fill_n(device.memory.begin() + 1024, 32, std::byte{7});
    CHECK(blitted({2, 6, 0, 4}, false) == std::vector<unsigned>{80, 120, 7, 7, 7, 7, 7, 7});
}
