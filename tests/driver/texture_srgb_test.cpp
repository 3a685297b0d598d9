// EXT_texture_sRGB through the GL's entry points, on the functional GPU.

#include "driver/context/offscreen.h"
#include "driver/entry_points/entry.h"
#include "model/gpu/functional_gpu.h"

#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr GLsizei Size = 4;

struct SrgbFixture {
    SrgbFixture()
        : device({.memory_bytes = 16u << 20})
        , gl(device, {.width = Size, .height = Size}) {
        gl.make_current();
        PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        PixelStorei(GL_PACK_ALIGNMENT, 1);
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    }

    // The one texel of an image given as RGBA bytes, drawn over the whole window and read back.
    static Bytes drawn_with(GLint internal, const Bytes& rgba) {
        TexImage2D(GL_TEXTURE_2D, 0, internal, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return drawn();
    }
    static Bytes drawn() {
        Enable(GL_TEXTURE_2D);
        TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
        Rectf(-1, -1, 1, 1);
        Disable(GL_TEXTURE_2D);
        Bytes pixel(4);
        ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
        return pixel;
    }
    static Bytes texels(GLint level, GLenum format, std::size_t bytes) {
        Bytes result(bytes);
        GetTexImage(GL_TEXTURE_2D, level, format, GL_UNSIGNED_BYTE, result.data());
        return result;
    }
    static GLint level_value(GLenum name) {
        GLint value = -1;
        GetTexLevelParameteriv(GL_TEXTURE_2D, 0, name, &value);
        return value;
    }

    FunctionalGpu device;
    OffscreenContext gl;
};

} // namespace

TEST_CASE_METHOD(SrgbFixture, "sRGB texels are drawn as linear light; alpha is linear already") {
    const Bytes rgba{0, 128, 255, 128}; // 128 is 0.2158 of full light.
    CHECK(drawn_with(GL_SRGB8_ALPHA8, rgba) == Bytes{0, 55, 255, 128});
    CHECK(drawn_with(GL_SRGB_ALPHA, rgba) == Bytes{0, 55, 255, 128});
    CHECK(drawn_with(GL_COMPRESSED_SRGB_ALPHA, rgba) == Bytes{0, 55, 255, 128});
    CHECK(drawn_with(GL_RGBA8, rgba) == rgba);
    const Bytes gray{128, 0, 0, 128};
    CHECK(drawn_with(GL_SLUMINANCE8_ALPHA8, gray) == Bytes{55, 55, 55, 128});
    CHECK(drawn_with(GL_COMPRESSED_SLUMINANCE_ALPHA, gray) == Bytes{55, 55, 55, 128});
}

TEST_CASE_METHOD(SrgbFixture, "S3TC blocks with sRGB end points are decoded, then linear") {
    // Both end points 0x8410: red 132, green 130, blue 132, whose light is 59, 57, 59.
    const Bytes block{0x10, 0x84, 0x10, 0x84, 0, 0, 0, 0};
    CompressedTexImage2D(
        GL_TEXTURE_2D, 0, GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, 4, 4, 0, 8, block.data());
    CHECK(GetError() == GL_NO_ERROR);
    const Bytes pixel = drawn();
    CHECK(pixel[0] == 59);
    CHECK(pixel[1] == 57);
    CHECK(pixel[2] == 59);
    Bytes back(8);
    GetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
    CHECK(back == block);
    CHECK(level_value(GL_TEXTURE_COMPRESSED) == GL_TRUE);
    CHECK(level_value(GL_TEXTURE_INTERNAL_FORMAT) == GL_COMPRESSED_SRGB_S3TC_DXT1_EXT);
}

TEST_CASE_METHOD(SrgbFixture, "images are read back and copied as codes, not as light") {
    const Bytes rgba{10, 128, 250, 77};
    drawn_with(GL_SRGB8_ALPHA8, rgba);
    CHECK(texels(0, GL_RGBA, 4) == rgba);
    CHECK(level_value(GL_TEXTURE_RED_SIZE) == 8);
    CHECK(level_value(GL_TEXTURE_ALPHA_SIZE) == 8);
    CHECK(level_value(GL_TEXTURE_INTERNAL_FORMAT) == GL_SRGB8_ALPHA8);
    RasterPos2f(-1, -1);
    DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    CopyTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, 0, 0, 1, 1, 0);
    CHECK(texels(0, GL_RGB, 3) == Bytes{10, 128, 250});
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(SrgbFixture, "a texture that turns from linear to sRGB in place is read anew") {
    const Bytes rgba{128, 128, 128, 255};
    CHECK(drawn_with(GL_RGBA8, rgba)[0] == 128);
    CHECK(drawn_with(GL_SRGB8_ALPHA8, rgba)[0] == 55);
    CHECK(drawn_with(GL_RGBA8, rgba)[0] == 128);
}

TEST_CASE_METHOD(SrgbFixture, "generated mip maps are means of light") {
    const Bytes texels_above{0, 0, 255, 100, 255, 0, 255, 200, 0, 0, 255, 100, 255, 0, 255, 200};
    TexImage2D(
        GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels_above.data());
    GenerateMipmap(GL_TEXTURE_2D);
    CHECK(texels(1, GL_RGBA, 4) == Bytes{188, 0, 255, 150}); // 188 is half of full light.
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(SrgbFixture, "drawing into an sRGB texture stores what is drawn") {
    GLuint framebuffer = 0;
    GenFramebuffers(1, &framebuffer);
    BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    GLuint texture = 0;
    GenTextures(1, &texture);
    BindTexture(GL_TEXTURE_2D, texture);
    TexImage2D(
        GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, Size, Size, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    REQUIRE(CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE);
    GLint encoding = 0;
    GetFramebufferAttachmentParameteriv(
        GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, &encoding);
    CHECK(encoding == GL_SRGB);
    ClearColor(0, 0.5f, 1, 1);
    Clear(GL_COLOR_BUFFER_BIT);
    Bytes pixel(4);
    ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
    CHECK(pixel == Bytes{0, 128, 255, 255});
    CHECK(GetError() == GL_NO_ERROR);
}
