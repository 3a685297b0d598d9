// The FXT1 compressor, and FXT1 images through the GL's entry points.

#include "driver/texel/block_codec.h"
#include "driver/texel/fxt1.h"
#include "model/arith/fxt1.h"
#include "tests/driver/state_fixture.h"

#include <numeric>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;
using namespace ffgpu::gl::entry;

namespace {

using Bytes = std::vector<std::uint8_t>;

Fxt1Texels round_trip(const Fxt1Texels& texels, bool alpha = true) {
    std::array<std::byte, 16> block;
    encode_fxt1(texels, alpha, block.data());
    Fxt1Texels result;
    for (unsigned i = 0; i < 32; ++i)
        result[i] = decode_fxt1(block.data(), i % 8, i / 8, alpha);
    return result;
}

Fxt1Texels solid(const Rgba8Texel& color) {
    Fxt1Texels texels;
    texels.fill(color);
    return texels;
}

int worst_error(const Fxt1Texels& a, const Fxt1Texels& b) {
    int worst = 0;
    for (unsigned i = 0; i < 32; ++i)
        for (unsigned c = 0; c < 4; ++c)
            worst = std::max(worst, std::abs(a[i][c] - b[i][c]));
    return worst;
}

} // namespace

TEST_CASE("colours that FXT1's precision can hold survive, whatever their alpha") {
    for (const Rgba8Texel color : {Rgba8Texel{0, 0, 0, 255},
                                   {255, 255, 255, 255},
                                   {255, 4, 0, 255}, // an odd green of six bits
                                   {132, 130, 8, 255}})
        CHECK(round_trip(solid(color)) == solid(color));
    for (const Rgba8Texel color : {Rgba8Texel{255, 0, 132, 132}, {0, 0, 0, 0}, {8, 16, 24, 0}})
        CHECK(round_trip(solid(color)) == solid(color));
}

TEST_CASE(
    "two opaque colours a tile are exact, with each combination of their greens' lowest bits") {
    for (unsigned bits = 0; bits < 16; ++bits) {
        const auto green = [&](unsigned bit) {
            const unsigned level = 20 + (bits >> bit & 1);
            return static_cast<std::uint8_t>(level << 2 | level >> 4);
        };
        Fxt1Texels texels;
        for (unsigned i = 0; i < 32; ++i) {
            const bool right = i % 8 >= 4, second = (i * 7 + bits) % 3 == 0;
            texels[i] = {static_cast<std::uint8_t>(second ? 255 : 0),
                         green((right ? 2u : 0u) + (second ? 1u : 0u)),
                         static_cast<std::uint8_t>(second ? 0 : 255),
                         255};
        }
        CHECK(round_trip(texels) == texels);
    }
}

TEST_CASE("three colours with alpha and clear are exact") {
    const Rgba8Texel palette[4] = {
        {255, 0, 0, 132}, {0, 255, 0, 255}, {0, 0, 255, 8}, {0, 0, 0, 0}};
    Fxt1Texels texels;
    for (unsigned i = 0; i < 32; ++i)
        texels[i] = palette[i * 5 % 4];
    CHECK(round_trip(texels) == texels);
}

TEST_CASE("a ramp of alpha stays within a step") {
    Fxt1Texels texels;
    for (unsigned i = 0; i < 32; ++i)
        texels[i] = {200, 100, 50, static_cast<std::uint8_t>(8 * i)};
    CHECK(worst_error(round_trip(texels), texels) <= 255 / 6 + 8);
}

TEST_CASE("without alpha every texel is opaque") {
    std::mt19937 random(5);
    for (int i = 0; i < 200; ++i) {
        Fxt1Texels texels;
        for (Rgba8Texel& texel : texels)
            for (std::uint8_t& channel : texel)
                channel = static_cast<std::uint8_t>(random() >> 9);
        for (const Rgba8Texel& texel : round_trip(texels, false))
            REQUIRE(texel[3] == 255);
    }
}

TEST_CASE("images that do not fill their FXT1 blocks keep their size, slice by slice") {
    const BlockImageSize size{11, 6, 3};
    std::vector<std::byte> rgba(std::size_t{4} * 11 * 6 * 3);
    for (std::size_t i = 0; i < rgba.size(); i += 4) {
        const auto level = static_cast<std::byte>(i / (4 * 11 * 6) * 66);
        rgba[i] = rgba[i + 1] = rgba[i + 2] = level;
        rgba[i + 3] = std::byte{255};
    }
    const auto blocks = compress(Format::Fxt1Rgb, rgba.data(), size);
    CHECK(blocks.size() == 2 * 2 * 3 * 16);
    const auto back = decompress(Format::Fxt1Rgb, blocks.data(), size);
    REQUIRE(back.size() == rgba.size());
    for (std::size_t i = 0; i < rgba.size(); ++i)
        REQUIRE(std::abs(std::to_integer<int>(back[i]) - std::to_integer<int>(rgba[i])) <= 4);
}

struct Fxt1Fixture : StateFixture {
    static GLint level_value(GLenum name) {
        GLint value = -1;
        GetTexLevelParameteriv(GL_TEXTURE_2D, 0, name, &value);
        return value;
    }
};

TEST_CASE_METHOD(Fxt1Fixture, "FXT1 blocks go to the device as they are, and come back so") {
    Bytes blocks(4 * 16);
    std::iota(blocks.begin(), blocks.end(), std::uint8_t{1});
    CompressedTexImage2D(
        GL_TEXTURE_2D, 0, GL_COMPRESSED_RGBA_FXT1_3DFX, 12, 8, 0, 64, blocks.data());
    CHECK(GetError() == GL_NO_ERROR);
    CHECK(level_value(GL_TEXTURE_COMPRESSED) == GL_TRUE);
    CHECK(level_value(GL_TEXTURE_COMPRESSED_IMAGE_SIZE) == 64);
    CHECK(level_value(GL_TEXTURE_INTERNAL_FORMAT) == GL_COMPRESSED_RGBA_FXT1_3DFX);
    Bytes back(64);
    GetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
    CHECK(back == blocks);
    Enable(GL_TEXTURE_2D);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    const TextureImage& image = drawn().images[0];
    CHECK(image.shape.format == Format::Fxt1Rgba);
    for (std::size_t i = 0; i < 64; ++i)
        REQUIRE(std::to_integer<std::uint8_t>(device.memory[image.address + i]) == blocks[i]);

    // The second block of the first row.
    const Bytes other(16, 0xcc);
    CompressedTexSubImage2D(
        GL_TEXTURE_2D, 0, 8, 0, 4, 4, GL_COMPRESSED_RGBA_FXT1_3DFX, 16, other.data());
    CHECK(GetError() == GL_NO_ERROR);
    GetCompressedTexImage(GL_TEXTURE_2D, 0, back.data());
    CHECK(std::equal(other.begin(), other.end(), back.begin() + 16));
    CHECK(std::equal(blocks.begin(), blocks.begin() + 16, back.begin()));
}

TEST_CASE_METHOD(Fxt1Fixture, "what does not keep to FXT1's blocks is refused") {
    const Bytes blocks(64);
    const auto part = [&](GLint x, GLint y, GLsizei width, GLsizei height) {
        CompressedTexSubImage2D(
            GL_TEXTURE_2D, 0, x, y, width, height, GL_COMPRESSED_RGB_FXT1_3DFX, 16, blocks.data());
        return GetError();
    };
    CompressedTexImage2D(
        GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_FXT1_3DFX, 16, 8, 0, 64, blocks.data());
    CHECK(GetError() == GL_NO_ERROR);
    CHECK(part(4, 0, 8, 4) == GL_INVALID_OPERATION);
    CHECK(part(0, 2, 8, 4) == GL_INVALID_OPERATION);
    CHECK(part(0, 0, 4, 4) == GL_INVALID_OPERATION);
    CHECK(part(8, 4, 8, 4) == GL_NO_ERROR);
    CompressedTexImage2D(
        GL_TEXTURE_2D, 0, GL_COMPRESSED_RGB_FXT1_3DFX, 16, 8, 0, 63, blocks.data());
    CHECK(GetError() == GL_INVALID_VALUE);
    CompressedTexImage1D(GL_TEXTURE_1D, 0, GL_COMPRESSED_RGB_FXT1_3DFX, 8, 0, 16, blocks.data());
    CHECK(GetError() == GL_INVALID_ENUM);
    CompressedTexImage3D(
        GL_TEXTURE_3D, 0, GL_COMPRESSED_RGB_FXT1_3DFX, 8, 4, 4, 0, 64, blocks.data());
    CHECK(GetError() == GL_NO_ERROR);
}

TEST_CASE_METHOD(Fxt1Fixture, "uncompressed pixels are compressed, and read back as texels") {
    Bytes texels(8 * 4 * 3);
    for (std::size_t i = 0; i < texels.size(); ++i)
        texels[i] = i % 3 == 0 ? 255 : 0;
    PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    PixelStorei(GL_PACK_ALIGNMENT, 1);
    TexImage2D(GL_TEXTURE_2D,
               0,
               GL_COMPRESSED_RGB_FXT1_3DFX,
               8,
               4,
               0,
               GL_RGB,
               GL_UNSIGNED_BYTE,
               texels.data());
    CHECK(level_value(GL_TEXTURE_COMPRESSED_IMAGE_SIZE) == 16);
    Bytes back(texels.size());
    GetTexImage(GL_TEXTURE_2D, 0, GL_RGB, GL_UNSIGNED_BYTE, back.data());
    CHECK(back == texels);
    GenerateMipmap(GL_TEXTURE_2D);
    Bytes one(3);
    GetTexImage(GL_TEXTURE_2D, 3, GL_RGB, GL_UNSIGNED_BYTE, one.data());
    CHECK(one == Bytes{255, 0, 0});
    CHECK(GetError() == GL_NO_ERROR);
}
