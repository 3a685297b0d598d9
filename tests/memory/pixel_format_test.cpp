#include "model/memory/pixel_format.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

constexpr Format ColorFormats[] = {Format::Rgba8,
                                   Format::Rgbx8,
                                   Format::Luminance8,
                                   Format::Alpha8,
                                   Format::Intensity8,
                                   Format::LuminanceAlpha8,
                                   Format::Rgb565,
                                   Format::Rgba4,
                                   Format::Rgb5a1};

std::uint32_t stored_and_loaded(Format format, std::uint32_t color) {
    std::byte bytes[4];
    store_rgba8(format, color, bytes);
    return load_rgba8(format, bytes);
}

} // namespace

TEST_CASE("Each format stores the channels it has and reads the others as its definition says") {
    const std::uint32_t color = pack_rgba8({0x11, 0x88, 0xcc, 0xee});
    const auto reads = [&](Format format) {
        return unpack_rgba8(stored_and_loaded(format, color));
    };
    REQUIRE(reads(Format::Rgba8) == PixelColor{0x11, 0x88, 0xcc, 0xee});
    REQUIRE(reads(Format::Rgbx8) == PixelColor{0x11, 0x88, 0xcc, 255});
    REQUIRE(reads(Format::Luminance8) == PixelColor{0x11, 0x11, 0x11, 255});
    REQUIRE(reads(Format::Alpha8) == PixelColor{0, 0, 0, 0xee});
    REQUIRE(reads(Format::Intensity8) == PixelColor{0x11, 0x11, 0x11, 0x11});
    REQUIRE(reads(Format::LuminanceAlpha8) == PixelColor{0x11, 0x11, 0x11, 0xee});
    REQUIRE(reads(Format::Rgba4) == PixelColor{0x11, 0x88, 0xcc, 0xee});
    REQUIRE(reads(Format::Rgb5a1)[3] == 255);
    REQUIRE(unpack_rgba8(stored_and_loaded(Format::Rgb5a1, 0x7fffffff))[3] == 0);
    REQUIRE(unpack_rgba8(stored_and_loaded(Format::Rgb5a1, 0x80000000))[3] == 255);
}

TEST_CASE("Red lies in the upper bits of the packed formats") {
    std::byte bytes[4];
    store_rgba8(Format::Rgb565, 0x000000ff, bytes);
    REQUIRE(load_word<std::uint16_t>(bytes) == 0xf800);
    store_rgba8(Format::Rgba4, 0x000000ff, bytes);
    REQUIRE(load_word<std::uint16_t>(bytes) == 0xf000);
    store_rgba8(Format::Rgb5a1, 0xff0000ff, bytes);
    REQUIRE(load_word<std::uint16_t>(bytes) == 0xf801);
}

TEST_CASE("Storing what was loaded changes no bit, for every 16-bit pixel") {
    for (const Format format : ColorFormats) {
        if (format_info(format).block_bytes != 2) continue;
        for (std::uint32_t pixel = 0; pixel < 65536; ++pixel) {
            std::byte bytes[2];
            store_word(bytes, static_cast<std::uint16_t>(pixel));
            const std::uint32_t color = load_rgba8(format, bytes);
            store_rgba8(format, color, bytes);
            if (load_word<std::uint16_t>(bytes) != pixel)
                REQUIRE(load_word<std::uint16_t>(bytes) == pixel);
        }
    }
    SUCCEED();
}

TEST_CASE("Quantizing is to the nearest level, with both ends exact") {
    for (const std::uint32_t maximum : {15u, 31u, 63u})
        for (std::uint32_t value = 0; value < 256; ++value)
            REQUIRE(quantize(value, maximum) ==
                    static_cast<std::uint32_t>(std::lround(value * maximum / 255.0)));
}

TEST_CASE(
    "Dithering keeps levels, keeps ends, moves by one level at most, and is right on average") {
    for (const unsigned bits : {4u, 5u, 6u}) {
        const std::uint32_t maximum = (1u << bits) - 1;
        for (std::uint32_t level = 0; level <= maximum; ++level)
            for (std::uint32_t bayer = 0; bayer < 16; ++bayer)
                REQUIRE(dither(widen_bits(level, bits), bits, bayer) == level);
        for (std::uint32_t value = 0; value < 256; ++value) {
            double sum = 0;
            for (std::uint32_t bayer = 0; bayer < 16; ++bayer) {
                const std::uint32_t level = dither(value, bits, bayer);
                REQUIRE(std::abs(level - value * maximum / 255.0) <= 1.0);
                sum += level;
            }
            REQUIRE(std::abs(sum / 16 - value * maximum / 255.0) < 0.25);
        }
    }
}

TEST_CASE("Every format's dithered pixel reads as one of the two levels around each channel") {
    for (const Format format : ColorFormats) {
        for (std::uint32_t value = 0; value < 256; ++value) {
            for (std::uint32_t bayer = 0; bayer < 16; ++bayer) {
                const std::uint32_t color = value * 0x01010101u;
                const std::uint32_t dithered =
                    unpack_pixel(format, pack_pixel(format, color, Dithered{bayer}));
                const std::uint32_t nearest = unpack_pixel(format, pack_pixel(format, color));
                if (!is_narrow(format)) REQUIRE(dithered == nearest);
                for (unsigned i = 0; i < 3; ++i)
                    REQUIRE(std::abs(static_cast<int>(dithered >> 8 * i & 255) -
                                     static_cast<int>(nearest >> 8 * i & 255)) <= 17);
                if (format == Format::Rgb5a1) REQUIRE(dithered >> 24 == (value < 128 ? 0 : 255));
            }
        }
    }
}

TEST_CASE("The bits of a channel in a pixel are those that the channel changes") {
    for (const Format format : ColorFormats) {
        for (unsigned i = 0; i < 4; ++i) {
            const std::uint32_t changed =
                pack_pixel(format, 0xffu << 8 * i) ^ pack_pixel(format, 0);
            const std::uint32_t spare = format == Format::Rgbx8 ? 0xff000000u : 0;
            REQUIRE((pixel_bits(format, 1u << i) & ~spare) == changed);
            REQUIRE((changed != 0) == ((stored_channels(format) >> i & 1) != 0));
        }
    }
}

TEST_CASE("The dither matrix holds each threshold once and repeats every four pixels") {
    std::vector<int> seen(16);
    for (std::uint32_t y = 0; y < 4; ++y)
        for (std::uint32_t x = 0; x < 4; ++x) {
            ++seen[bayer_threshold(x, y)];
            REQUIRE(bayer_threshold(x, y) == bayer_threshold(x + 4, y + 8));
        }
    REQUIRE(seen == std::vector<int>(16, 1));
}

TEST_CASE("Depth goes from 16 bits to 24 and back without loss, ends to ends") {
    for (std::uint32_t depth = 0; depth < 65536; ++depth)
        if (depth16_from_depth24(depth24_from_depth16(depth)) != depth)
            REQUIRE(depth16_from_depth24(depth24_from_depth16(depth)) == depth);
    REQUIRE(depth24_from_depth16(0xffff) == Depth24Maximum);
    REQUIRE(depth24_from_depth16(0) == 0);
}

TEST_CASE("Storing a depth keeps the stencil bits") {
    std::byte bytes[4];
    store_word(bytes, std::uint32_t{0xaabbccdd});
    const std::uint32_t depth = 0x123456;
    store_depth24(Format::Depth24Stencil8, std::span(&depth, 1), bytes);
    REQUIRE(load_word<std::uint32_t>(bytes) == 0x123456dd);
}

TEST_CASE("Floats become units clamped, to nearest, and NaN is 0") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    REQUIRE(unorm8_from_float(nan) == 0);
    REQUIRE(unorm8_from_float(-1) == 0);
    REQUIRE(unorm8_from_float(2) == 255);
    REQUIRE(unorm8_from_float(0.5f) == 128);
    for (int i = 0; i < 256; ++i)
        REQUIRE(unorm8_from_float(static_cast<float>(i) / 255.0f) == i);
    REQUIRE(depth_units(Format::Depth24Stencil8, nan) == 0);
    REQUIRE(depth_units(Format::Depth24Stencil8, 1) == Depth24Maximum);
    REQUIRE(depth_units(Format::Depth24Stencil8, 2) == Depth24Maximum);
    REQUIRE(depth_units(Format::Depth24Stencil8, 0.5f) == 0x800000);
    REQUIRE(depth_units(Format::Depth16, 1) == 0xffff);
    REQUIRE(depth_units(Format::Depth16, -0.0f) == 0);
}

TEST_CASE("A surface fits if its last byte does and its rows do not overlap") {
    const Surface surface{
        .address = 100, .format = Format::Rgba8, .width = 10, .height = 4, .stride = 64};
    const std::uint64_t end = 100 + 3 * 64 + 40;
    REQUIRE(surface_fits(surface, end));
    REQUIRE_FALSE(surface_fits(surface, end - 1));
    Surface wild = surface;
    wild.address = 0xffffffff;
    wild.stride = 0xffffffff;
    REQUIRE_FALSE(surface_fits(wild, 1u << 30));
    wild = surface;
    wild.stride = 39;
    REQUIRE_FALSE(surface_fits(wild, 1u << 20));
    wild.height = 1;
    REQUIRE(surface_fits(wild, 1u << 20));
    wild = surface;
    wild.width = 0;
    REQUIRE_FALSE(surface_fits(wild, 1u << 20));
    for (const Format format : {Format::None, Format::Dxt1Rgb, static_cast<Format>(31)}) {
        wild = surface;
        wild.format = format;
        REQUIRE_FALSE(surface_fits(wild, 1u << 20));
    }
}
