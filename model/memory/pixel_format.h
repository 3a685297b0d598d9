// Pixels in memory: rows of colours (color_pixel.h) and depths, and the surfaces that hold them.
//
// A colour in a register or a word is rgba8 with red in the lowest byte. Device memory is little
// endian, and so are the hosts that the emulator runs on.

#pragma once

#include "model/device/extents.h"
#include "model/device/layout/formats.h"
#include "model/device/registers/fragment.h"
#include "model/memory/color_pixel.h"

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

// Consecutive pixels of a row, of a plain colour format.
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

// Depths in 24-bit units, of a format of depth targets. Storing keeps the stencil bits of
// Depth24Stencil8.
void load_depth24(Format format, const std::byte* from, std::span<std::uint32_t> depths);
void store_depth24(Format format, std::span<const std::uint32_t> depths, std::byte* to);

// --- Surfaces ---------------------------------------------------------------------------------

// Nobody touches a surface that surface_fits() (model/device/extents.h) was not asked about.
inline std::uint64_t pixel_place(const Surface& surface, std::uint32_t x, std::uint32_t y) {
    return surface.address + std::uint64_t{y} * surface.stride +
           std::uint64_t{x} * format_info(surface.format).block_bytes;
}

inline std::byte* pixel_address(const Surface& surface,
                                std::span<std::byte> memory,
                                std::uint32_t x,
                                std::uint32_t y) {
    return memory.data() + pixel_place(surface, x, y);
}

} // namespace ffgpu
