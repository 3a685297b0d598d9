// Texture images through the GL's entry points.

#include "driver/objects/texture_object.h"
#include "tests/driver/state_fixture.h"

#include <numeric>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes ramp(std::size_t count) {
    Bytes bytes(count);
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{1});
    return bytes;
}

struct TextureFixture : StateFixture {
    TextureFixture() {
        PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        PixelStorei(GL_PACK_ALIGNMENT, 1);
    }

    static void define_2d(GLint internal, GLsizei width, GLsizei height, const void* pixels) {
        TexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    }
    static Bytes get_2d(GLenum format, std::size_t bytes, GLint level = 0) {
        Bytes pixels(bytes);
        GetTexImage(GL_TEXTURE_2D, level, format, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }
    static GLint level_value(GLenum target, GLenum name, GLint level = 0) {
        GLint value = -1;
        GetTexLevelParameteriv(target, level, name, &value);
        return value;
    }
    // As a draw would: the texture goes to device memory.
    const TextureImage& resident_image() {
        Enable(GL_TEXTURE_2D);
        TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        return drawn().images[0];
    }
    Bytes on_device(DeviceAddress at, std::size_t bytes) const {
        Bytes result(bytes);
        for (std::size_t i = 0; i < bytes; ++i)
            result[i] = std::to_integer<std::uint8_t>(device.memory[at + i]);
        return result;
    }
};

} // namespace

TEST_CASE_METHOD(TextureFixture,
                 "texels come back as they went, before and after they are drawn with") {
    const Bytes texels = ramp(4 * 4 * 3);
    define_2d(GL_RGBA, 4, 3, texels.data());
    CHECK(get_2d(GL_RGBA, texels.size()) == texels);
    const TextureImage& image = resident_image();
    CHECK(image.shape.format == Format::Rgba8);
    CHECK(on_device(image.address, texels.size()) == texels);
    CHECK(get_2d(GL_RGBA, texels.size()) == texels);
}

TEST_CASE_METHOD(TextureFixture, "each base format keeps its channels and gives back table 6.1's") {
    const Bytes rgba{10, 20, 30, 40};
    struct Case {
        GLint internal;
        Format format;
        Bytes back; // as GL_RGBA
    };
    const Case cases[] = {{GL_ALPHA, Format::Alpha8, {0, 0, 0, 40}},
                          {GL_LUMINANCE, Format::Luminance8, {10, 0, 0, 255}},
                          {GL_LUMINANCE_ALPHA, Format::LuminanceAlpha8, {10, 0, 0, 40}},
                          {GL_INTENSITY, Format::Intensity8, {10, 0, 0, 255}},
                          {GL_RGB, Format::Rgbx8, {10, 20, 30, 255}},
                          {3, Format::Rgbx8, {10, 20, 30, 255}},
                          {GL_RGBA, Format::Rgba8, {10, 20, 30, 40}},
                          {GL_RGB5, Format::Rgb565, {8, 20, 33, 255}},
                          {GL_RGBA4, Format::Rgba4, {17, 17, 34, 34}},
                          {GL_RGB5_A1, Format::Rgb5a1, {8, 16, 33, 0}}};
    for (const Case& one : cases) {
        INFO("internal format " << one.internal);
        define_2d(one.internal, 1, 1, rgba.data());
        CHECK(resident_image().shape.format == one.format);
        CHECK(get_2d(GL_RGBA, 4) == one.back);
    }
}

TEST_CASE_METHOD(TextureFixture, "the luminance of an image is its red, not a sum") {
    const Bytes rgba{10, 20, 30, 40};
    define_2d(GL_RGBA, 1, 1, rgba.data());
    CHECK(get_2d(GL_LUMINANCE_ALPHA, 2) == Bytes{10, 40});
}

TEST_CASE_METHOD(TextureFixture, "a part is written where it belongs, in both places") {
    for (const bool resident : {false, true}) {
        define_2d(GL_RGBA, 4, 4, Bytes(64, 0).data());
        if (resident) resident_image();
        const Bytes part = ramp(2 * 2 * 4);
        TexSubImage2D(GL_TEXTURE_2D, 0, 1, 2, 2, 2, GL_RGBA, GL_UNSIGNED_BYTE, part.data());
        Bytes expected(64, 0);
        std::copy_n(part.begin(), 8, expected.begin() + (2 * 4 + 1) * 4);
        std::copy_n(part.begin() + 8, 8, expected.begin() + (3 * 4 + 1) * 4);
        CHECK(get_2d(GL_RGBA, 64) == expected);
    }
}

TEST_CASE_METHOD(TextureFixture, "a border is stored around the image, at negative coordinates") {
    const Bytes texels = ramp(6 * 4);
    TexImage2D(
        GL_TEXTURE_2D, 0, GL_LUMINANCE, 6, 4, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
    const std::uint8_t corner = 200;
    TexSubImage2D(GL_TEXTURE_2D, 0, -1, -1, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &corner);
    CHECK(GetError() == GL_NO_ERROR);
    const TextureImage& image = resident_image();
    CHECK(image.shape.width == 4);
    CHECK(image.shape.height == 2);
    CHECK(image.shape.border == 1);
    CHECK(get_2d(GL_LUMINANCE, 1 * 24)[0] == 200);
    TexSubImage2D(GL_TEXTURE_2D, 0, -2, 0, 1, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, &corner);
    CHECK(GetError() == GL_INVALID_VALUE);
}

TEST_CASE_METHOD(TextureFixture, "slices and faces lie one after the other") {
    const Bytes texels = ramp(2 * 2 * 3);
    TexImage3D(GL_TEXTURE_3D, 0, GL_ALPHA, 2, 2, 3, 0, GL_ALPHA, GL_UNSIGNED_BYTE, texels.data());
    TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    Enable(GL_TEXTURE_3D);
    CHECK(on_device(drawn().images[0].address, 12) == texels);

    TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    for (GLenum face = 0; face < 6; ++face) {
        TexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face,
                   0,
                   GL_ALPHA,
                   1,
                   1,
                   0,
                   GL_ALPHA,
                   GL_UNSIGNED_BYTE,
                   texels.data() + face);
    }
    Enable(GL_TEXTURE_CUBE_MAP);
    CHECK(drawn().images[0].shape.kind == TextureKind::Cube);
    CHECK(on_device(device.registers.images[0].address, 6) == ramp(6));
}

TEST_CASE_METHOD(TextureFixture, "the wrong arguments of an image are the specified errors") {
    const auto define = [](GLenum target, GLint level, GLint internal, GLsizei size, GLint border) {
        TexImage2D(target, level, internal, size, size, border, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        return GetError();
    };
    CHECK(define(GL_TEXTURE_1D, 0, GL_RGBA, 4, 0) == GL_INVALID_ENUM);
    CHECK(define(GL_TEXTURE_2D, -1, GL_RGBA, 4, 0) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_2D, 13, GL_RGBA, 1, 0) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_2D, 0, GL_BYTE, 4, 0) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_2D, 0, GL_RGBA, -4, 0) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_2D, 0, GL_RGBA, 4097, 0) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_2D, 1, GL_RGBA, 2049, 0) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_2D, 0, GL_RGBA, 4, 2) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_RECTANGLE, 1, GL_RGBA, 4, 0) == GL_INVALID_VALUE);
    CHECK(define(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, 4, 0) == GL_INVALID_OPERATION);
    CHECK(define(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0) == GL_NO_ERROR);
    TexImage2D(
        GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, GL_RGBA, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    CHECK(GetError() == GL_INVALID_VALUE);
    TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 4, 4, 0, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, nullptr);
    CHECK(GetError() == GL_INVALID_ENUM);
    const auto define_depth = [](GLenum target, GLenum format) {
        TexImage2D(target, 0, GL_DEPTH_COMPONENT, 4, 4, 0, format, GL_UNSIGNED_BYTE, nullptr);
        return GetError();
    };
    CHECK(define_depth(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, GL_DEPTH_COMPONENT) == GL_NO_ERROR);
    CHECK(define_depth(GL_TEXTURE_2D, GL_STENCIL_INDEX) == GL_INVALID_OPERATION);
    TexSubImage2D(GL_TEXTURE_2D, 3, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    CHECK(GetError() == GL_INVALID_OPERATION);
}

TEST_CASE_METHOD(TextureFixture, "a proxy tells what would work, without an error") {
    TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 64, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    CHECK(level_value(GL_PROXY_TEXTURE_2D, GL_TEXTURE_WIDTH) == 64);
    CHECK(level_value(GL_PROXY_TEXTURE_2D, GL_TEXTURE_RED_SIZE) == 8);
    CHECK(level_value(GL_PROXY_TEXTURE_2D, GL_TEXTURE_ALPHA_SIZE) == 0);
    TexImage2D(GL_PROXY_TEXTURE_2D, 0, GL_RGB, 8192, 32, 0, GL_RGB, GL_UNSIGNED_BYTE, nullptr);
    CHECK(level_value(GL_PROXY_TEXTURE_2D, GL_TEXTURE_WIDTH) == 0);
    CHECK(GetError() == GL_NO_ERROR);
    CHECK(level_value(GL_TEXTURE_2D, GL_TEXTURE_WIDTH) == 0);
}

TEST_CASE_METHOD(TextureFixture, "blocks go to the device as they are, and come back so") {
    const Bytes blocks = ramp(2 * 16);
    CompressedTexImage2D(
        GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 8, 4, 0, 32, blocks.data());
    REQUIRE(GetError() == GL_NO_ERROR);
    CHECK(level_value(GL_TEXTURE_2D, GL_TEXTURE_COMPRESSED) == 1);
    CHECK(level_value(GL_TEXTURE_2D, GL_TEXTURE_COMPRESSED_IMAGE_SIZE) == 32);
    CHECK(on_device(resident_image().address, 32) == blocks);
    const Bytes block(16, 9);
    CompressedTexSubImage2D(
        GL_TEXTURE_2D, 0, 4, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, block.data());
    Bytes expected = blocks;
    std::fill(expected.begin() + 16, expected.end(), std::uint8_t{9});
    Bytes back(32);
    GetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
    CHECK(back == expected);
    CompressedTexSubImage2D(
        GL_TEXTURE_2D, 0, 2, 0, 4, 4, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 16, block.data());
    CHECK(GetError() == GL_INVALID_OPERATION);
    CompressedTexImage2D(
        GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_S3TC_DXT5_EXT, 8, 4, 0, 31, blocks.data());
    CHECK(GetError() == GL_INVALID_VALUE);
}

TEST_CASE_METHOD(TextureFixture, "deleted textures give their memory back, also when bound") {
    const std::uint64_t before = gl.shared()->memory->bytes_in_use();
    for (int i = 0; i < 3; ++i) {
        GLuint name = 0;
        GenTextures(1, &name);
        BindTexture(GL_TEXTURE_2D, name);
        define_2d(GL_RGBA, 16, 16, nullptr);
        resident_image();
        CHECK(gl.shared()->memory->bytes_in_use() == before + 1024);
        DeleteTextures(1, &name);
        CHECK(IsTexture(name) == GL_FALSE);
        CHECK(get_int(GL_TEXTURE_BINDING_2D) == 0);
        CHECK(gl.shared()->memory->bytes_in_use() == before);
    }
}

TEST_CASE_METHOD(TextureFixture, "generated mip maps follow the base level") {
    TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
    const Bytes texels{0, 4, 8, 100, 4, 8, 12, 100}; // 4 x 2
    TexImage2D(
        GL_TEXTURE_2D, 0, GL_LUMINANCE, 4, 2, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
    CHECK(get_2d(GL_LUMINANCE, 2, 1) == Bytes{4, 55});
    CHECK(get_2d(GL_LUMINANCE, 1, 2) == Bytes{30}); // (4 + 55) / 2, rounded.
    const Bytes part{200, 200};
    TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 2, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, part.data());
    CHECK(get_2d(GL_LUMINANCE, 2, 1) == Bytes{103, 55});
    Enable(GL_TEXTURE_2D);
    CHECK(drawn().images[0].shape.levels == 3);
}

TEST_CASE_METHOD(TextureFixture, "of odd sizes each texel is weighted by what is covered of it") {
    const Bytes texels{0, 90, 30, 60, 120}; // 5 texels become 2.
    TexImage1D(GL_TEXTURE_1D, 0, GL_LUMINANCE, 5, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texels.data());
    GenerateMipmap(GL_TEXTURE_1D);
    Bytes half(2);
    GetTexImage(GL_TEXTURE_1D, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, half.data());
    CHECK(half == Bytes{(2 * 0 + 2 * 90 + 1 * 30 + 2) / 5, (1 * 30 + 2 * 60 + 2 * 120 + 2) / 5});
}

TEST_CASE_METHOD(TextureFixture, "a unit with an incomplete texture is off") {
    Enable(GL_TEXTURE_2D);
    define_2d(GL_RGBA, 4, 4, nullptr); // Mip maps are missing.
    CHECK(drawn().images[0].shape.kind == TextureKind::None);
    CHECK_FALSE(device.registers.combiners[0].enable);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    CHECK(drawn().images[0].shape.kind == TextureKind::TwoD);
    CHECK(device.registers.combiners[0].enable);
}

TEST_CASE_METHOD(TextureFixture, "parameters that a target does not take are refused") {
    TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_WRAP_S, GL_REPEAT);
    CHECK(GetError() == GL_INVALID_ENUM);
    TexParameteri(GL_TEXTURE_RECTANGLE, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    CHECK(GetError() == GL_INVALID_ENUM);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    CHECK(GetError() == GL_INVALID_ENUM);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, -1);
    CHECK(GetError() == GL_INVALID_VALUE);
    TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 0.5f);
    CHECK(GetError() == GL_INVALID_VALUE);
    TexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 3);
    CHECK(GetError() == GL_INVALID_VALUE);
    TexEnvi(GL_TEXTURE_ENV, GL_OPERAND0_ALPHA, GL_SRC_COLOR);
    CHECK(GetError() == GL_INVALID_ENUM);
    TexGeni(GL_Q, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
    CHECK(GetError() == GL_INVALID_ENUM);
    GLuint name = 7;
    BindTexture(GL_TEXTURE_3D, name);
    BindTexture(GL_TEXTURE_2D, name);
    CHECK(GetError() == GL_INVALID_OPERATION);
}

TEST_CASE_METHOD(TextureFixture, "an eye plane is taken to eye coordinates when it is set") {
    MatrixMode(GL_MODELVIEW);
    Translatef(3, 0, 0);
    const GLfloat plane[4] = {1, 0, 0, 0};
    TexGenfv(GL_S, GL_EYE_PLANE, plane);
    LoadIdentity();
    GLfloat back[4];
    GetTexGenfv(GL_S, GL_EYE_PLANE, back);
    CHECK(back[0] == 1);
    CHECK(back[3] == -3);
}
