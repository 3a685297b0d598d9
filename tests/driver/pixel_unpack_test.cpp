// Pixels of every format and type, unpacked and packed, against the formulas of GL 1.5, tables 2.6,
// 3.5 to 3.8 and 4.7.

#include "driver/pixel/pack.h"
#include "driver/pixel/pixel_format.h"
#include "driver/pixel/unpack.h"
#include "driver/texel/texel_codec.h"
#include "driver/texture/image_upload.h"

#include <cstring>
#include <random>

#include <catch2/catch.hpp>

using namespace ffgpu;
using namespace ffgpu::gl;

namespace {

constexpr PixelStore Tight{.alignment = 1};

template <class Element, std::size_t Count>
PixelColor unpack_one(GLenum format,
                      GLenum type,
                      const std::array<Element, Count>& elements,
                      PixelStore store = Tight) {
    const PixelSource source(elements.data(), store, {1, 1, 1}, format, type);
    PixelColor color;
    unpack_colors(source, source.row(0), &color);
    return color;
}

void check_color(const PixelColor& actual, const std::array<double, 4>& expected) {
    for (std::size_t i = 0; i < 4; ++i) {
        INFO("channel " << i);
        CHECK(static_cast<double>(actual[i]) == Approx(expected[i]).margin(1e-6));
    }
}

template <class Element>
Element pack_one(GLenum format, GLenum type, const PixelColor& color, PixelStore store = Tight) {
    Element element{};
    const PixelDestination destination(&element, store, {1, 1, 1}, format, type);
    pack_colors(destination, destination.row(0), &color);
    return element;
}

constexpr std::array<GLenum, 11> ColorFormats{GL_RED,
                                              GL_GREEN,
                                              GL_BLUE,
                                              GL_ALPHA,
                                              GL_RGB,
                                              GL_RGBA,
                                              GL_BGR,
                                              GL_BGRA,
                                              GL_ABGR_EXT,
                                              GL_LUMINANCE,
                                              GL_LUMINANCE_ALPHA};
constexpr std::array<GLenum, 12> PackedTypes{GL_UNSIGNED_BYTE_3_3_2,
                                             GL_UNSIGNED_BYTE_2_3_3_REV,
                                             GL_UNSIGNED_SHORT_5_6_5,
                                             GL_UNSIGNED_SHORT_5_6_5_REV,
                                             GL_UNSIGNED_SHORT_4_4_4_4,
                                             GL_UNSIGNED_SHORT_4_4_4_4_REV,
                                             GL_UNSIGNED_SHORT_5_5_5_1,
                                             GL_UNSIGNED_SHORT_1_5_5_5_REV,
                                             GL_UNSIGNED_INT_8_8_8_8,
                                             GL_UNSIGNED_INT_8_8_8_8_REV,
                                             GL_UNSIGNED_INT_10_10_10_2,
                                             GL_UNSIGNED_INT_2_10_10_10_REV};
constexpr std::array<GLenum, 7> PlainTypes{
    GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT};

} // namespace

TEST_CASE("each type is converted to [0, 1] or [-1, 1] by its formula") {
    using Bytes = std::array<std::uint8_t, 4>;
    check_color(unpack_one(GL_RGBA, GL_UNSIGNED_BYTE, Bytes{0, 51, 128, 255}),
                {0, 0.2, 128 / 255.0, 1});
    check_color(unpack_one(GL_RGBA, GL_BYTE, std::array<std::int8_t, 4>{-128, 0, 1, 127}),
                {-1, 1 / 255.0, 3 / 255.0, 1});
    check_color(
        unpack_one(GL_RGBA, GL_UNSIGNED_SHORT, std::array<std::uint16_t, 4>{0, 1, 32768, 65535}),
        {0, 1 / 65535.0, 32768 / 65535.0, 1});
    check_color(unpack_one(GL_RGBA, GL_SHORT, std::array<std::int16_t, 4>{-32768, 0, 1, 32767}),
                {-1, 1 / 65535.0, 3 / 65535.0, 1});
    check_color(
        unpack_one(GL_RGBA, GL_UNSIGNED_INT, std::array<std::uint32_t, 4>{0, 1u << 31, 1, ~0u}),
        {0, 0.5, 0, 1});
    check_color(unpack_one(GL_RGBA,
                           GL_INT,
                           std::array<std::int32_t, 4>{-2147483647 - 1, 0, 1 << 30, 2147483647}),
                {-1, 0, 0.5, 1});
    check_color(unpack_one(GL_RGBA, GL_FLOAT, std::array<float, 4>{-2, 0.25f, 1, 3}),
                {-2, 0.25, 1, 3});
}

TEST_CASE("each format puts its components into their channels") {
    const std::array<std::uint8_t, 4> bytes{51, 102, 153, 204}; // 0.2 0.4 0.6 0.8
    const auto unpacked = [&](GLenum format) {
        return unpack_one(format, GL_UNSIGNED_BYTE, bytes);
    };
    check_color(unpacked(GL_RED), {0.2, 0, 0, 1});
    check_color(unpacked(GL_GREEN), {0, 0.2, 0, 1});
    check_color(unpacked(GL_BLUE), {0, 0, 0.2, 1});
    check_color(unpacked(GL_ALPHA), {0, 0, 0, 0.2});
    check_color(unpacked(GL_RGB), {0.2, 0.4, 0.6, 1});
    check_color(unpacked(GL_RGBA), {0.2, 0.4, 0.6, 0.8});
    check_color(unpacked(GL_BGR), {0.6, 0.4, 0.2, 1});
    check_color(unpacked(GL_BGRA), {0.6, 0.4, 0.2, 0.8});
    check_color(unpacked(GL_ABGR_EXT), {0.8, 0.6, 0.4, 0.2});
    check_color(unpacked(GL_LUMINANCE), {0.2, 0.2, 0.2, 1});
    check_color(unpacked(GL_LUMINANCE_ALPHA), {0.2, 0.2, 0.2, 0.4});
}

TEST_CASE("packed types hold their fields where table 3.8 says") {
    const auto one = [](auto word) { return std::array{word}; };
    const auto u8 = [&](unsigned word) { return one(static_cast<std::uint8_t>(word)); };
    const auto u16 = [&](unsigned word) { return one(static_cast<std::uint16_t>(word)); };
    const auto u32 = [&](unsigned word) { return one(static_cast<std::uint32_t>(word)); };
    check_color(unpack_one(GL_RGB, GL_UNSIGNED_BYTE_3_3_2, u8(0b101'011'10)),
                {5 / 7.0, 3 / 7.0, 2 / 3.0, 1});
    check_color(unpack_one(GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, u8(0b10'011'101)),
                {5 / 7.0, 3 / 7.0, 2 / 3.0, 1});
    check_color(unpack_one(GL_RGB, GL_UNSIGNED_SHORT_5_6_5, u16(20 << 11 | 30 << 5 | 10)),
                {20 / 31.0, 30 / 63.0, 10 / 31.0, 1});
    check_color(unpack_one(GL_RGB, GL_UNSIGNED_SHORT_5_6_5_REV, u16(10 << 11 | 30 << 5 | 20)),
                {20 / 31.0, 30 / 63.0, 10 / 31.0, 1});
    check_color(unpack_one(GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, u16(0x369c)), {0.2, 0.4, 0.6, 0.8});
    check_color(unpack_one(GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4_REV, u16(0xc963)),
                {0.2, 0.4, 0.6, 0.8});
    check_color(unpack_one(GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, u16(31 << 11 | 1 << 1)),
                {1, 0, 1 / 31.0, 0});
    check_color(unpack_one(GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, u16(0x8000 | 31)), {0, 0, 1, 1});
    check_color(unpack_one(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, u32(0x336699cc)),
                {0.2, 0.4, 0.6, 0.8});
    check_color(unpack_one(GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, u32(0xcc336699)),
                {0.2, 0.4, 0.6, 0.8});
    check_color(unpack_one(GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, u32(1023u << 22 | 2)),
                {1, 0, 0, 2 / 3.0});
    check_color(unpack_one(GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, u32(2u << 30 | 1023)),
                {1, 0, 0, 2 / 3.0});
}

TEST_CASE("swapped bytes are swapped in each element") {
    PixelStore store = Tight;
    store.swap_bytes = true;
    check_color(unpack_one(GL_RED, GL_UNSIGNED_SHORT, std::array<std::uint16_t, 1>{0x0100}, store),
                {1 / 65535.0, 0, 0, 1});
    check_color(
        unpack_one(
            GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, std::array<std::uint32_t, 1>{0xcc996633}, store),
        {0.2, 0.4, 0.6, 0.8});
    CHECK(pack_one<std::uint16_t>(GL_RED, GL_UNSIGNED_SHORT, {1 / 65535.0f, 0, 0, 0}, store) ==
          0x0100);
}

TEST_CASE("what was unpacked packs to the same bits, for each format and type") {
    std::mt19937 random(7);
    const auto check_round_trip = [&](GLenum format, GLenum type) {
        if (format_type_error(format, type) != GL_NO_ERROR) return;
        INFO("format " << format << " type " << type);
        std::array<std::uint32_t, 16> words{};
        for (std::uint32_t& word : words)
            word = static_cast<std::uint32_t>(random()) & 0x7f7f7f7f; // Signed values >= 0.
        if (type == GL_FLOAT) {
            for (std::uint32_t& word : words)
                word = std::bit_cast<std::uint32_t>(static_cast<float>(word >> 8) / 16777216.0f);
        }
        const ImageSize size{3, 1, 1};
        const PixelSource source(words.data(), Tight, size, format, type);
        std::array<PixelColor, 3> colors;
        unpack_colors(source, source.row(0), colors.data());
        // Luminance is packed as the sum of three channels (4.3.2): the first alone is its value.
        if (component_order(format).luminance) {
            for (PixelColor& color : colors)
                color[1] = color[2] = 0;
        }
        std::array<std::uint32_t, 16> packed{};
        const PixelDestination destination(packed.data(), Tight, size, format, type);
        pack_colors(destination, destination.row(0), colors.data());
        const std::size_t bytes = 3 * pixel_bytes(format, type);
        const bool wide = type == GL_UNSIGNED_INT || type == GL_INT; // 24 bits reach the channels.
        if (!wide) CHECK(std::memcmp(packed.data(), words.data(), bytes) == 0);
        for (std::size_t i = 0; wide && i < bytes / 4; ++i)
            CHECK(std::abs(static_cast<double>(packed[i]) - static_cast<double>(words[i])) <= 256);
    };
    for (const GLenum format : ColorFormats) {
        for (const GLenum type : PlainTypes)
            check_round_trip(format, type);
        for (const GLenum type : PackedTypes)
            check_round_trip(format, type);
    }
}

TEST_CASE("packing clamps, and adds red, green and blue to luminance") {
    CHECK(pack_one<std::uint8_t>(GL_LUMINANCE, GL_UNSIGNED_BYTE, {0.2f, 0.2f, 0.2f, 1}) == 153);
    CHECK(pack_one<std::uint8_t>(GL_LUMINANCE, GL_UNSIGNED_BYTE, {0.9f, 0.9f, 0, 1}) == 255);
    CHECK(pack_one<std::uint8_t>(GL_RED, GL_UNSIGNED_BYTE, {-1, 0, 0, 1}) == 0);
    CHECK(pack_one<float>(GL_RED, GL_FLOAT, {2, 0, 0, 1}) == 1.0f);
    CHECK(pack_one<std::int8_t>(GL_RED, GL_BYTE, {1, 0, 0, 1}) == 127);
    CHECK(pack_one<std::int32_t>(GL_RED, GL_INT, {1, 0, 0, 1}) == 2147483647);
}

TEST_CASE("formats and types that do not go together are errors") {
    CHECK(format_type_error(GL_RGBA, GL_UNSIGNED_SHORT_5_6_5) == GL_INVALID_OPERATION);
    CHECK(format_type_error(GL_BGR, GL_UNSIGNED_SHORT_5_6_5) == GL_INVALID_OPERATION);
    CHECK(format_type_error(GL_RGB, GL_UNSIGNED_INT_8_8_8_8) == GL_INVALID_OPERATION);
    CHECK(format_type_error(GL_RGB, GL_BITMAP) == GL_INVALID_ENUM);
    CHECK(format_type_error(GL_COLOR_INDEX, GL_BITMAP) == GL_NO_ERROR);
    CHECK(format_type_error(GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8) == GL_NO_ERROR);
    CHECK(format_type_error(GL_DEPTH_STENCIL, GL_FLOAT) == GL_INVALID_ENUM);
    CHECK(format_type_error(GL_RGBA, GL_UNSIGNED_INT_24_8) == GL_INVALID_OPERATION);
    CHECK(format_type_error(GL_TEXTURE_2D, GL_FLOAT) == GL_INVALID_ENUM);
    CHECK(format_type_error(GL_RGB, GL_RGB) == GL_INVALID_ENUM);
}

TEST_CASE("uploads of bytes take the same texels as the general way") {
    std::mt19937 random(11);
    std::array<std::uint32_t, 64> words;
    for (std::uint32_t& word : words)
        word = static_cast<std::uint32_t>(random());
    constexpr std::array Stored{Format::Rgba8,
                                Format::Rgbx8,
                                Format::Luminance8,
                                Format::Alpha8,
                                Format::Intensity8,
                                Format::LuminanceAlpha8};
    constexpr std::array<GLenum, 3> Types{
        GL_UNSIGNED_BYTE, GL_UNSIGNED_INT_8_8_8_8, GL_UNSIGNED_INT_8_8_8_8_REV};
    unsigned compared = 0;
    for (const GLenum format : ColorFormats) {
        for (const GLenum type : Types) {
            for (const bool swap : {false, true}) {
                if (format_type_error(format, type) != GL_NO_ERROR) continue;
                PixelStore store = Tight;
                store.swap_bytes = swap;
                const PixelSource source(words.data(), store, {13, 1, 1}, format, type);
                std::array<PixelColor, 13> colors;
                unpack_colors(source, source.row(0), colors.data());
                for (const Format stored : Stored) {
                    INFO("format " << format << " type " << type << " swap " << swap);
                    std::array<std::byte, 52> fast{}, general{};
                    REQUIRE(unpack_fast(source, stored, fast.data()));
                    encode_colors(stored, colors, general.data());
                    CHECK(fast == general);
                    ++compared;
                }
            }
        }
    }
    CHECK(compared >= 6 * (11 + 6) * 2);
}
