// One pixel of each uncompressed format: how it reads as rgba8, and how rgba8 is stored in it.
// Clears, copies, image draws and colour targets share these definitions.
//
// A colour in a register or a word is rgba8 with red in the lowest byte. Device memory is little
// endian, and so are the hosts that the emulator runs on.

#pragma once

#include "model/device/formats.h"
#include "model/device/registers/fragment.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace ffgpu {

// Red, green, blue, alpha, 0 .. 255 each.
using PixelColor = std::array<std::uint8_t, 4>;

constexpr std::uint32_t pack_rgba8(const PixelColor& color) {
    return color[0] | std::uint32_t{color[1]} << 8 | std::uint32_t{color[2]} << 16 |
           std::uint32_t{color[3]} << 24;
}

constexpr PixelColor unpack_rgba8(std::uint32_t word) {
    return {static_cast<std::uint8_t>(word),
            static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word >> 16),
            static_cast<std::uint8_t>(word >> 24)};
}

// [0, 1] to 0 .. 255, to nearest, ties up; what is outside is clamped, NaN is 0.
constexpr std::uint8_t unorm8_from_float(float value) {
    if (!(value > 0.0f)) return 0;
    return value < 1.0f ? static_cast<std::uint8_t>(value * 255.0f + 0.5f) : std::uint8_t{255};
}

// --- Fewer than eight bits --------------------------------------------------------------------

// 8 bits to 0 .. maximum, to nearest.
constexpr std::uint32_t quantize(std::uint32_t value, std::uint32_t maximum) {
    return (value * maximum + 127) / 255;
}

// 8 bits to 5 or 6, up or down by the place in the window; `bayer` is 0 .. 15. Over a 4x4 block the
// mean is within a quarter level of value (2^bits - 1) / 255.
constexpr std::uint32_t dither(std::uint32_t value, unsigned bits, std::uint32_t bayer) {
    const unsigned dropped = 8 - bits;
    return (value - (value >> bits) + (bayer >> (4 - dropped))) >> dropped;
}

// Bayer's ordered 4x4 matrix.
constexpr std::uint32_t bayer_threshold(std::uint32_t x, std::uint32_t y) {
    constexpr std::uint8_t Bayer[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    return Bayer[y % 4][x % 4];
}

// A level of 4 to 7 bits as 8 bits, by repeating its upper bits. Both quantize and dither give the
// level back: what is read and stored again stays.
constexpr std::uint32_t widen_bits(std::uint32_t level, unsigned bits) {
    return level << (8 - bits) | level >> (2 * bits - 8);
}

constexpr std::uint32_t rgba8_from_rgb565(std::uint32_t pixel) {
    return widen_bits(pixel >> 11, 5) | widen_bits(pixel >> 5 & 63, 6) << 8 |
           widen_bits(pixel & 31, 5) << 16 | 0xff000000u;
}

constexpr std::uint16_t pack_rgb565(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
    return static_cast<std::uint16_t>(red << 11 | green << 5 | blue);
}

constexpr std::uint16_t rgb565_from_rgba8(std::uint32_t color) {
    return pack_rgb565(
        quantize(color & 255, 31), quantize(color >> 8 & 255, 63), quantize(color >> 16 & 255, 31));
}

// For the pixel (x, y) of the window.
constexpr std::uint16_t dither_rgb565(std::uint32_t color, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t bayer = bayer_threshold(x, y);
    return pack_rgb565(dither(color & 255, 5, bayer),
                       dither(color >> 8 & 255, 6, bayer),
                       dither(color >> 16 & 255, 5, bayer));
}

// --- Depth ------------------------------------------------------------------------------------

constexpr std::uint32_t Depth24Maximum = 0xffffff;

constexpr std::uint32_t depth24_from_depth16(std::uint32_t depth) {
    return depth << 8 | depth >> 8;
}
constexpr std::uint32_t depth16_from_depth24(std::uint32_t depth) {
    return depth >> 8;
}

// Window depth in [0, 1] to the units of a depth format, to nearest; clamped, NaN is 0.
std::uint32_t depth_units(Format format, float depth);

// --- Memory -----------------------------------------------------------------------------------

template <class Word>
Word load_word(const std::byte* at) {
    Word word;
    std::memcpy(&word, at, sizeof word);
    return word;
}

template <class Word>
void store_word(std::byte* at, Word word) {
    std::memcpy(at, &word, sizeof word);
}

// Uncompressed and with colour: what load_rgba8 and store_rgba8 take.
constexpr bool is_plain_color(Format format) {
    return format >= Format::Rgba8 && format <= Format::Rgb5a1;
}

// What load_depth24 and store_depth24 take. (A format from a file may be none of the list.)
constexpr bool is_depth_target(Format format) {
    return format == Format::Depth16 || format == Format::Depth24Stencil8;
}

// Consecutive pixels of a row. Luminance takes red, intensity red, alpha formats alpha; a channel
// that a format lacks reads as formats.h says, and its stored spare byte is 255.
void load_rgba8(Format format, const std::byte* from, std::span<std::uint32_t> colors);
void store_rgba8(Format format, std::span<const std::uint32_t> colors, std::byte* to);

inline std::uint32_t load_rgba8(Format format, const std::byte* from) {
    std::uint32_t color = 0;
    load_rgba8(format, from, std::span(&color, 1));
    return color;
}

inline void store_rgba8(Format format, std::uint32_t color, std::byte* to) {
    store_rgba8(format, std::span(&color, 1), to);
}

// Depths in 24-bit units. Storing keeps the stencil bits of Depth24Stencil8.
void load_depth24(Format format, const std::byte* from, std::span<std::uint32_t> depths);
void store_depth24(Format format, std::span<const std::uint32_t> depths, std::byte* to);

// --- Surfaces ---------------------------------------------------------------------------------

// Does every pixel of the surface lie in memory, and do its rows not overlap? A command stream may
// come from a file: nobody touches a surface that this was not asked about.
bool surface_fits(const Surface& surface, std::uint64_t memory_size);

inline std::byte* pixel_address(const Surface& surface,
                                std::span<std::byte> memory,
                                std::uint32_t x,
                                std::uint32_t y) {
    return memory.data() + surface.address + std::uint64_t{y} * surface.stride +
           std::uint64_t{x} * format_info(surface.format).block_bytes;
}

} // namespace ffgpu
