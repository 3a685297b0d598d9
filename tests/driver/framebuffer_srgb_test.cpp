// EXT_framebuffer_sRGB through the GL's entry points, on the functional GPU. Expected values are
// the extension's formula in double precision.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <array>
#include <cmath>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Pixel = std::array<std::uint8_t, 4>;
constexpr GLsizei Size = 8;

std::uint8_t code(double light) {
    const double c = light < 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(255 * c + 0.5);
}

double light(unsigned code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

struct FramebufferSrgbFixture {
    FramebufferSrgbFixture()
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = Size, .height = Size}) {
        gl.make_current();
    }

    static Pixel pixel() {
        Pixel read{};
        ReadPixels(1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, read.data());
        return read;
    }
    static Pixel drawn(const Pixel& color) {
        Color4ub(color[0], color[1], color[2], color[3]);
        Rectf(-1, -1, 1, 1);
        return pixel();
    }
    static Pixel cleared(GLbitfield red) {
        ClearColor(static_cast<float>(red) / 255, 0, 1, 0.5f);
        Clear(GL_COLOR_BUFFER_BIT);
        return pixel();
    }
    static void attach(GLenum point, GLint format) {
        GLuint texture = 0;
        GenTextures(1, &texture);
        BindTexture(GL_TEXTURE_2D, texture);
        TexImage2D(GL_TEXTURE_2D, 0, format, Size, Size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        BindTexture(GL_TEXTURE_2D, 0);
        FramebufferTexture2D(GL_FRAMEBUFFER, point, GL_TEXTURE_2D, texture, 0);
    }
    static void bind_object() {
        GLuint framebuffer = 0;
        GenFramebuffers(1, &framebuffer);
        BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    }
    static bool is_capable() {
        GLboolean capable = GL_FALSE;
        GetBooleanv(GL_FRAMEBUFFER_SRGB_CAPABLE_EXT, &capable);
        return capable == GL_TRUE;
    }

    FunctionalGpu device;
    OffscreenContext gl;
};

} // namespace

TEST_CASE_METHOD(FramebufferSrgbFixture, "what is drawn to a window is encoded while it is asked") {
    CHECK(is_capable());
    for (unsigned level = 0; level < 256; level += 5) {
        const auto n = static_cast<std::uint8_t>(level);
        const Pixel color{n, 0, 255, n};
        Disable(GL_FRAMEBUFFER_SRGB);
        CHECK(drawn(color) == color);
        CHECK(cleared(level)[0] == level);
        Enable(GL_FRAMEBUFFER_SRGB);
        CHECK(drawn(color) == Pixel{code(level / 255.0), 0, 255, n});
        CHECK(cleared(level) == Pixel{code(level / 255.0), 0, 255, 128});
    }
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(FramebufferSrgbFixture, "blending mixes light; logic operations do nothing") {
    Enable(GL_FRAMEBUFFER_SRGB);
    Enable(GL_BLEND);
    BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    for (const unsigned alpha : {0u, 51u, 128u, 255u}) {
        Disable(GL_BLEND);
        const unsigned before = drawn({100, 100, 100, 255})[0];
        Enable(GL_BLEND);
        const double a = alpha / 255.0;
        const double mixed = a * 200 / 255 + (1 - a) * light(before);
        CHECK(drawn({200, 0, 0, static_cast<std::uint8_t>(alpha)})[0] == code(mixed));
    }
    Enable(GL_COLOR_LOGIC_OP); // Blending stays off with it, though it has no effect.
    entry::LogicOp(GL_XOR);
    CHECK(drawn({60, 0, 0, 0})[0] == code(60 / 255.0));
}

TEST_CASE_METHOD(FramebufferSrgbFixture, "pixels are read as codes, and drawn ones are encoded") {
    Enable(GL_FRAMEBUFFER_SRGB);
    drawn({55, 55, 55, 255});
    const std::uint8_t once = code(55 / 255.0);
    CHECK(pixel()[0] == once);
    RasterPos2f(-1, -1);
    CopyPixels(0, 0, Size, Size, GL_COLOR);
    CHECK(pixel()[0] == code(once / 255.0));
    const Pixel given{55, 55, 55, 55};
    RasterPos2f(-0.75f, -0.75f);
    DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, given.data());
    CHECK(pixel() == Pixel{once, once, once, 55});
}

TEST_CASE_METHOD(FramebufferSrgbFixture,
                 "of an object's images those of sRGB formats are encoded") {
    Enable(GL_FRAMEBUFFER_SRGB);
    bind_object();
    attach(GL_COLOR_ATTACHMENT0, GL_RGBA8);
    REQUIRE(CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    CHECK(!is_capable());
    CHECK(drawn({55, 0, 0, 255})[0] == 55);
    attach(GL_COLOR_ATTACHMENT1, GL_SRGB8_ALPHA8);
    const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    DrawBuffers(2, both);
    CHECK(is_capable());
    for (const bool clears : {false, true}) {
        clears ? (void)cleared(55) : (void)drawn({55, 0, 255, 128});
        ReadBuffer(GL_COLOR_ATTACHMENT0);
        CHECK(pixel() == Pixel{55, 0, 255, 128});
        ReadBuffer(GL_COLOR_ATTACHMENT1);
        CHECK(pixel() == Pixel{code(55 / 255.0), 0, 255, 128});
    }
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE("samples of an sRGB window are encoded one by one") {
    FunctionalGpu device({.memory_bytes = 16u << 20});
    OffscreenContext gl(device, {.width = Size, .height = Size, .format = {.samples = 4}});
    gl.make_current();
    Enable(GL_FRAMEBUFFER_SRGB);
    CHECK(FramebufferSrgbFixture::drawn({55, 0, 0, 255})[0] == code(55 / 255.0));
}

TEST_CASE("the reference stages draw the same into an sRGB window") {
    Pixel results[2];
    for (const bool reference : {false, true}) {
        FunctionalGpu device(
            {.memory_bytes = 16u << 20, .stages = reference ? &ReferenceStages : &FastStages});
        OffscreenContext gl(device, {.width = Size, .height = Size});
        gl.make_current();
        Enable(GL_FRAMEBUFFER_SRGB);
        Enable(GL_BLEND);
        BlendFunc(GL_ONE, GL_ONE);
        FramebufferSrgbFixture::drawn({11, 22, 33, 44});
        results[reference] = FramebufferSrgbFixture::drawn({99, 88, 77, 66});
    }
    CHECK(results[0] == results[1]);
    CHECK(results[0][0] == code(std::fma(1.0, light(code(11 / 255.0)), 99 / 255.0)));
}
