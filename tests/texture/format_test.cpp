// Texel decode: each format by its comment in model/device/layout/formats.h, S3TC blocks by hand.

#include "model/texture/s3tc.h"
#include "model/texture/texel_decode.h"
#include "tests/texture/texture_fixture.h"

#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>

namespace ffgpu::test {
namespace {

Color decode(Format format, std::initializer_list<unsigned> bytes) {
    TextureMemory memory(TextureShape{TextureKind::TwoD, format, 1, 1, 1, 1, 0});
    std::byte* at = memory.at(0, 0, 0, 0);
    for (const unsigned byte : bytes)
        *at++ = static_cast<std::byte>(byte);
    return sample_point(memory.compile(nearest_sampler()), {0.5f, 0.5f});
}

TEST_CASE("colour formats of 8 bits a channel read as their layout says") {
    CHECK(decode(Format::Rgba8, {1, 2, 3, 4}) == Color{1, 2, 3, 4});
    CHECK(decode(Format::Rgbx8, {1, 2, 3, 4}) == Color{1, 2, 3, 255});
    CHECK(decode(Format::Luminance8, {9}) == Color{9, 9, 9, 255});
    CHECK(decode(Format::Alpha8, {9}) == Color{0, 0, 0, 9});
    CHECK(decode(Format::Intensity8, {9}) == Color{9, 9, 9, 9});
    CHECK(decode(Format::LuminanceAlpha8, {9, 7}) == Color{9, 9, 9, 7});
}

TEST_CASE("packed formats widen every value to the nearest 8 bits") {
    for (unsigned bits = 0; bits < 65536; bits += 7) {
        const auto low = bits & 0xff, high = bits >> 8;
        const auto widened = [](unsigned value, unsigned most) {
            return static_cast<double>(value) * 255 / most;
        };
        const auto near = [](unsigned actual, double exact) {
            return std::abs(actual - exact) < 1;
        };
        const Color rgb565 = decode(Format::Rgb565, {low, high});
        REQUIRE(near(rgb565[0], widened(bits >> 11, 31)));
        REQUIRE(near(rgb565[1], widened(bits >> 5 & 63, 63)));
        REQUIRE(near(rgb565[2], widened(bits & 31, 31)));
        REQUIRE(rgb565[3] == 255);
        const Color rgba4 = decode(Format::Rgba4, {low, high});
        for (unsigned c = 0; c < 4; ++c)
            REQUIRE(rgba4[c] == (bits >> (12 - 4 * c) & 15) * 17);
        const Color rgb5a1 = decode(Format::Rgb5a1, {low, high});
        for (unsigned c = 0; c < 3; ++c)
            REQUIRE(near(rgb5a1[c], widened(bits >> (11 - 5 * c) & 31, 31)));
        REQUIRE(rgb5a1[3] == (bits & 1) * 255);
    }
}

TEST_CASE("sRGB texels are read as linear light before they are filtered") {
    TextureMemory memory(TextureShape{TextureKind::TwoD, Format::Rgba8, 2, 1, 1, 1, 0});
    memory.image.srgb = true;
    memory.put_rgba8(0, 0, 0, 0, 0x80ff8000u); // r 0, g 128, b 255, a 128
    memory.put_rgba8(0, 0, 1, 0, 0x00ff80ffu);
    const TextureUnit nearest = memory.compile(nearest_sampler());
    CHECK(sample_point(nearest, {0.25f, 0.5f}) == Color{0, 55, 255, 128});
    // Between codes 0 and 255 lies half of the light, not the light of half the code.
    const TextureUnit linear = memory.compile(linear_sampler(Wrap::ClampToEdge));
    CHECK(sample_point(linear, {0.5f, 0.5f}) == Color{128, 55, 255, 64});
}

TEST_CASE("the border colour of an sRGB texture is linear already, a stored border is not") {
    TextureMemory memory(TextureShape{TextureKind::TwoD, Format::Luminance8, 1, 1, 1, 1, 0});
    memory.image.srgb = true;
    Sampler sampler = nearest_sampler(Wrap::ClampToBorder);
    sampler.border_color = 0xff808080u;
    CHECK(sample_point(memory.compile(sampler), {2, 0.5f}) == Color{128, 128, 128, 255});

    TextureMemory stored(TextureShape{TextureKind::TwoD, Format::Luminance8, 1, 1, 1, 1, 1});
    stored.image.srgb = true;
    *stored.at(0, 0, 2, 1) = std::byte{128};
    CHECK(sample_point(stored.compile(sampler), {2, 0.5f}) == Color{55, 55, 55, 255});
}

// A block of DXT1: two colours, and codes 0 1 2 3 in each row, from the left.
struct Block {
    std::array<std::byte, 16> bytes{};
    void put(unsigned at, std::initializer_list<unsigned> values) {
        for (const unsigned value : values)
            bytes[at++] = static_cast<std::byte>(value);
    }
};

Block color_block(unsigned at, unsigned c0, unsigned c1) {
    Block block;
    block.put(at, {c0 & 0xff, c0 >> 8, c1 & 0xff, c1 >> 8, 0xe4, 0xe4, 0xe4, 0xe4});
    return block;
}

constexpr unsigned Red = 0xf800, Blue = 0x001f;

TEST_CASE("DXT1 with the greater colour first has four colours") {
    const Block block = color_block(0, Red, Blue);
    for (const Format format : {Format::Dxt1Rgb, Format::Dxt1Rgba}) {
        CHECK(decode_s3tc(format, block.bytes.data(), 0, 0) == Rgba{255, 0, 0, 255});
        CHECK(decode_s3tc(format, block.bytes.data(), 1, 1) == Rgba{0, 0, 255, 255});
        CHECK(decode_s3tc(format, block.bytes.data(), 2, 2) == Rgba{170, 0, 85, 255});
        CHECK(decode_s3tc(format, block.bytes.data(), 3, 3) == Rgba{85, 0, 170, 255});
    }
}

TEST_CASE("DXT1 otherwise has three and black, clear where the format has alpha") {
    const Block block = color_block(0, Blue, Red);
    CHECK(decode_s3tc(Format::Dxt1Rgb, block.bytes.data(), 2, 0) == Rgba{127, 0, 127, 255});
    CHECK(decode_s3tc(Format::Dxt1Rgb, block.bytes.data(), 3, 0) == Rgba{0, 0, 0, 255});
    CHECK(decode_s3tc(Format::Dxt1Rgba, block.bytes.data(), 3, 0) == Rgba{0, 0, 0, 0});
    const Block equal = color_block(0, Red, Red);
    CHECK(decode_s3tc(Format::Dxt1Rgba, equal.bytes.data(), 3, 0) == Rgba{0, 0, 0, 0});
}

TEST_CASE("DXT3 has four bits of alpha a texel and always four colours") {
    Block block = color_block(8, Blue, Red);
    block.put(0, {0x10, 0x32, 0, 0, 0, 0, 0, 0xf0});
    CHECK(decode_s3tc(Format::Dxt3, block.bytes.data(), 0, 0) == Rgba{0, 0, 255, 0});
    CHECK(decode_s3tc(Format::Dxt3, block.bytes.data(), 1, 0)[3] == 17);
    CHECK(decode_s3tc(Format::Dxt3, block.bytes.data(), 2, 0) == Rgba{85, 0, 170, 34});
    CHECK(decode_s3tc(Format::Dxt3, block.bytes.data(), 3, 3) == Rgba{170, 0, 85, 255});
}

TEST_CASE("DXT5 interpolates alphas in sevenths, or in fifths with 0 and 255") {
    Block block = color_block(8, Blue, Red);
    // Codes 0 .. 7 for the first eight texels: 111 110 101 100 011 010 001 000 from the top bit.
    block.put(0, {210, 70, 0x88, 0xc6, 0xfa, 0x88, 0xc6, 0xfa});
    const auto alpha = [&](unsigned texel) {
        return decode_s3tc(Format::Dxt5, block.bytes.data(), texel % 4, texel / 4)[3];
    };
    const std::array<unsigned, 8> sevenths{210, 70, 190, 170, 150, 130, 110, 90};
    for (unsigned i = 0; i < 16; ++i)
        CHECK(alpha(i) == sevenths[i % 8]);
    block.put(0, {70, 210});
    const std::array<unsigned, 8> fifths{70, 210, 98, 126, 154, 182, 0, 255};
    for (unsigned i = 0; i < 16; ++i)
        CHECK(alpha(i) == fifths[i % 8]);
}

TEST_CASE("the vector form's products divide by 3, 5 and 7 exactly") {
    for (unsigned value = 0; value <= 2040; ++value) {
        REQUIRE((value * 21846 >> 16) == value / 3);
        REQUIRE((value * 13108 >> 16) == value / 5);
        REQUIRE((value * 9363 >> 16) == value / 7);
    }
}

} // namespace
} // namespace ffgpu::test
