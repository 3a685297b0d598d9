// The driver's S3TC against the sampler's.

#include "driver/texel/block_codec.h"
#include "driver/texel/s3tc.h"
#include "model/texture/s3tc.h"

#include <cstring>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;

namespace {

constexpr std::array Formats{Format::Dxt1Rgb, Format::Dxt1Rgba, Format::Dxt3, Format::Dxt5};

TexelBlock solid(Rgba8Texel color) {
    TexelBlock texels;
    texels.fill(color);
    return texels;
}

TexelBlock round_trip(Format format, const TexelBlock& texels) {
    std::array<std::byte, 16> block{};
    encode_block(format, texels, block.data());
    return decode_block(format, block.data());
}

} // namespace

TEST_CASE("blocks decode to the very texels that the sampler reads") {
    std::mt19937 random(1);
    for (int i = 0; i < 4000; ++i) {
        std::array<std::uint32_t, 4> words;
        for (std::uint32_t& word : words)
            word = static_cast<std::uint32_t>(random());
        if (i % 4 == 0) words[0] = words[0] << 16 | words[0] >> 16; // Both orders of the ends.
        std::array<std::byte, 16> block;
        std::memcpy(block.data(), words.data(), block.size());
        for (const Format format : Formats) {
            const TexelBlock texels = decode_block(format, block.data());
            for (unsigned texel = 0; texel < 16; ++texel) {
                const auto expected = decode_s3tc(format, block.data(), texel % 4, texel / 4);
                REQUIRE(texels[texel] ==
                        Rgba8Texel{expected[0], expected[1], expected[2], expected[3]});
            }
        }
    }
}

TEST_CASE("colours that 5 and 6 bits can hold survive compression") {
    for (const Format format : Formats) {
        for (const Rgba8Texel color : {Rgba8Texel{0, 0, 0, 255},
                                       {255, 255, 255, 255},
                                       {255, 0, 0, 255},
                                       {132, 130, 57, 255}}) {
            CHECK(round_trip(format, solid(color)) == solid(color));
        }
    }
}

TEST_CASE("a block of two colours is exact, whichever way its channels run") {
    TexelBlock texels = solid({255, 0, 0, 255});
    for (std::size_t i = 0; i < 16; i += 3)
        texels[i] = {0, 0, 255, 255}; // Blue rises where red falls.
    for (const Format format : Formats)
        CHECK(round_trip(format, texels) == texels);
}

TEST_CASE("DXT1 with alpha keeps transparent texels transparent and the others opaque") {
    TexelBlock texels = solid({255, 255, 255, 255});
    texels[5] = texels[6] = {0, 0, 0, 0};
    CHECK(round_trip(Format::Dxt1Rgba, texels) == texels);
    CHECK(round_trip(Format::Dxt1Rgb, texels)[5] == Rgba8Texel{0, 0, 0, 255});
}

TEST_CASE("alpha is kept to half a step of its palette") {
    TexelBlock texels;
    for (unsigned i = 0; i < 16; ++i)
        texels[i] = {255, 255, 255, static_cast<std::uint8_t>(17 * i)};
    CHECK(round_trip(Format::Dxt3, texels) == texels);
    const TexelBlock eighths = round_trip(Format::Dxt5, texels);
    for (unsigned i = 0; i < 16; ++i)
        CHECK(std::abs(eighths[i][3] - texels[i][3]) <= 19); // The palette's step is 255 / 7.
    CHECK(eighths[0][3] == 0);
    CHECK(eighths[15][3] == 255);
}

TEST_CASE("images that end within a block keep their texels") {
    const std::uint32_t width = 6, height = 5;
    std::vector<std::byte> rgba(width * height * 4, std::byte{255});
    for (std::size_t i = 0; i < width * height; i += 2)
        rgba[4 * i] = rgba[4 * i + 1] = rgba[4 * i + 2] = std::byte{0};
    for (const Format format : Formats) {
        const auto blocks = compress(format, rgba.data(), {width, height});
        CHECK(blocks.size() == std::size_t{4} * format_info(format).block_bytes);
        CHECK(decompress(format, blocks.data(), {width, height}) == rgba);
    }
}
