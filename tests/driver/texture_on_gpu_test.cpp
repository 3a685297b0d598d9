// The driver on the functional GPU: pixels that go in, through textures, copies and framebuffer
// objects, come out as the specification says.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr GLsizei Size = 16;

struct GpuFixture {
    GpuFixture()
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = Size, .height = Size}) {
        gl.make_current();
        PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        PixelStorei(GL_PACK_ALIGNMENT, 1);
        Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    }

    static Bytes noise(std::size_t count) {
        std::mt19937 random(3);
        Bytes bytes(count);
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random() >> 8);
        return bytes;
    }
    static Bytes read(GLsizei width, GLsizei height, GLenum format = GL_RGBA) {
        Bytes pixels(static_cast<std::size_t>(width * height * (format == GL_RGBA ? 4 : 1)));
        ReadPixels(0, 0, width, height, format, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    static Bytes texels(GLsizei width, GLsizei height) {
        Bytes result(static_cast<std::size_t>(width * height * 4));
        GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, result.data());
        return result;
    }
    static void define(GLint internal, GLsizei width, GLsizei height, const void* pixels) {
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    }
    // The whole texture onto the whole viewport.
    static void draw_texture() {
        Enable(GL_TEXTURE_2D);
        TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        Begin(GL_QUADS);
        for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            TexCoord2f(static_cast<float>(x + 1) / 2, static_cast<float>(y + 1) / 2);
            Vertex2i(x, y);
        }
        End();
        Disable(GL_TEXTURE_2D);
    }

    FunctionalGpu device;
    OffscreenContext gl;
};

} // namespace

TEST_CASE_METHOD(GpuFixture, "drawn pixels are read back bit for bit") {
    const Bytes pixels = noise(Size * Size * 4);
    DrawPixels(Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    CHECK(read(Size, Size) == pixels);
    const Bytes stencils = noise(Size * Size);
    DrawPixels(Size, Size, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
    CHECK(read(Size, Size, GL_STENCIL_INDEX) == stencils);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(GpuFixture, "drawn depths are read back, and colours take the raster colour") {
    Enable(GL_DEPTH_TEST);
    DepthFunc(GL_ALWAYS);
    std::vector<std::uint32_t> depths(Size * Size);
    for (std::size_t i = 0; i < depths.size(); ++i)
        depths[i] = static_cast<std::uint32_t>(i) * 0x01010101; // The same part of 2^24 - 1.
    Color3f(1, 0, 0);
    WindowPos2i(0, 0);
    DrawPixels(Size, Size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, depths.data());
    std::vector<std::uint32_t> back(Size * Size);
    ReadPixels(0, 0, Size, Size, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, back.data());
    CHECK(back == depths);
    CHECK(read(1, 1) == Bytes{255, 0, 0, 255});
}

TEST_CASE_METHOD(GpuFixture, "a texture drawn texel to pixel is its texels") {
    const Bytes pixels = noise(Size * Size * 4);
    define(GL_RGBA, Size, Size, pixels.data());
    draw_texture();
    CHECK(read(Size, Size) == pixels);
    // Changed while it is resident, in part.
    const Bytes part{1, 2, 3, 4};
    TexSubImage2D(GL_TEXTURE_2D, 0, 5, 7, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
    draw_texture();
    Bytes expected = pixels;
    std::copy(part.begin(), part.end(), expected.begin() + (7 * Size + 5) * 4);
    CHECK(read(Size, Size) == expected);
}

TEST_CASE_METHOD(GpuFixture, "each format is sampled as its texels read") {
    const Bytes pixels = noise(Size * Size * 4);
    const auto drawn_channel = [&](GLint internal, std::size_t channel) {
        Clear(GL_COLOR_BUFFER_BIT);
        Color4f(1, 1, 1, 1);
        define(internal, Size, Size, pixels.data());
        draw_texture();
        const Bytes drawn = read(Size, Size), stored = texels(Size, Size);
        int worst = 0;
        for (std::size_t i = channel; i < drawn.size(); i += 4)
            worst = std::max(worst, std::abs(drawn[i] - stored[i]));
        return worst;
    };
    for (const GLint internal : {GL_RGBA, GL_RGB, GL_RGBA4, GL_RGB5_A1, GL_RGB5, GL_LUMINANCE}) {
        INFO("internal format " << internal);
        CHECK(drawn_channel(internal, 0) <= 1); // 5 bits widen by repeating bits.
    }
    for (const GLint internal : {GL_ALPHA, GL_RGBA, GL_LUMINANCE_ALPHA, GL_RGBA4, GL_RGB5_A1})
        CHECK(drawn_channel(internal, 3) <= 1);
    for (const GLint internal : {GL_COMPRESSED_RGB_S3TC_DXT1_EXT, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT})
        CHECK(drawn_channel(internal, 1) == 0);
}

TEST_CASE_METHOD(GpuFixture, "the framebuffer is copied to textures of each format") {
    const Bytes pixels = noise(Size * Size * 4);
    DrawPixels(Size, Size, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    CopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, Size, Size, 0);
    CHECK(texels(Size, Size) == pixels);
    for (const bool on_device : {true, false}) {
        PixelTransferf(GL_RED_BIAS, on_device ? 0.0f : 1e-9f); // Changes nothing but the way.
        CopyTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE_ALPHA, 2, 3, 4, 4, 0);
        const Bytes copied = texels(4, 4);
        for (std::size_t i = 0; i < 16; ++i) {
            const std::size_t from = ((3 + i / 4) * Size + 2 + i % 4) * 4;
            REQUIRE(copied[4 * i] == pixels[from]);
            REQUIRE(copied[4 * i + 3] == pixels[from + 3]);
        }
        CopyTexSubImage2D(GL_TEXTURE_2D, 0, 1, 1, Size - 1, 0, 2, 1); // Half of it is outside.
        CHECK(texels(4, 4)[(1 * 4 + 1) * 4] == pixels[(Size - 1) * 4]);
        CHECK(texels(4, 4)[(1 * 4 + 2) * 4] == copied[(1 * 4 + 2) * 4]);
    }
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(GpuFixture, "a picture drawn into a texture can be drawn with") {
    GLuint names[2], framebuffer = 0;
    GenTextures(2, names);
    const Bytes pixels = noise(8 * 8 * 4);
    BindTexture(GL_TEXTURE_2D, names[0]);
    define(GL_RGBA, 8, 8, pixels.data());
    BindTexture(GL_TEXTURE_2D, names[1]);
    define(GL_RGBA, 8, 8, nullptr);
    GenFramebuffers(1, &framebuffer);
    BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names[1], 0);
    entry::Viewport(0, 0, 8, 8);
    BindTexture(GL_TEXTURE_2D, names[0]);
    draw_texture();
    CHECK(read(8, 8) == pixels);
    BindFramebuffer(GL_FRAMEBUFFER, 0);
    BindTexture(GL_TEXTURE_2D, names[1]);
    draw_texture();
    CHECK(read(8, 8).front() == pixels.front());
    CHECK(texels(8, 8) == pixels);

    BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    BlitFramebuffer(0, 0, 8, 8, 4, 4, 12, 12, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    Bytes blitted(8 * 8 * 4);
    ReadPixels(4, 4, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, blitted.data());
    CHECK(blitted == pixels);
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(GpuFixture,
                 "a texture's own picture survives the levels that are copied from it") {
    GLuint name = 0, framebuffer = 0;
    GenTextures(1, &name);
    const Bytes pixels = noise(8 * 8 * 4);
    BindTexture(GL_TEXTURE_2D, name);
    define(GL_RGBA, 8, 8, pixels.data());
    GenFramebuffers(1, &framebuffer);
    BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, name, 0);
    CopyTexImage2D(GL_TEXTURE_2D, 1, GL_RGBA, 0, 0, 4, 4, 0); // The chain grows and moves.
    Bytes level(4 * 4 * 4);
    GetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, level.data());
    for (std::size_t i = 0; i < 16; ++i)
        REQUIRE(level[4 * i] == pixels[(i / 4 * 8 + i % 4) * 4]);
    CHECK(read(8, 8) == pixels);
}

TEST_CASE_METHOD(GpuFixture, "a bitmap sets the pixels of its bits") {
    Color3f(0, 1, 0);
    WindowPos2i(2, 1);
    const Bytes bits{0b10110000, 0b01000000};
    Bitmap(4, 2, 0, 0, 0, 0, bits.data());
    const Bytes pixels = read(Size, Size);
    const auto green = [&](std::size_t x, std::size_t y) {
        return pixels[(y * Size + x) * 4 + 1] == 255;
    };
    for (std::size_t x = 0; x < 8; ++x) {
        CHECK(green(x, 1) == (x == 2 || x == 4 || x == 5));
        CHECK(green(x, 2) == (x == 3));
        CHECK_FALSE(green(x, 0));
    }
}
