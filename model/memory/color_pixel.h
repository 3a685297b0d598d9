// One pixel of each uncompressed colour format: the word that is stored for an rgba8 colour, and
// the colour that a stored word reads as. The one definition that clears, copies, image draws,
// colour targets and their tests share.
//
// A colour is rgba8 with red in the lowest byte. Luminance and intensity are written by red, alpha
// formats by alpha; a channel that a format lacks reads as model/device/layout/formats.h says.

#pragma once

#include "model/device/layout/formats.h"

#include <cstdint>
#include <type_traits>

namespace ffgpu {

// --- Fewer than eight bits --------------------------------------------------------------------

// 8 bits to 0 .. maximum, to nearest.
constexpr std::uint32_t quantize(std::uint32_t value, std::uint32_t maximum) {
    return (value * maximum + 127) / 255;
}

// 8 bits to 4, 5 or 6, up or down by the place in the window; `bayer` is 0 .. 15. Over a 4x4 block
// the mean is within a quarter level of value (2^bits - 1) / 255.
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

// How a channel of 8 bits comes to fewer. Dithering leaves the one bit of Rgb5a1's alpha alone: a
// pattern of holes would be no likeness of a half transparent surface.
struct ToNearest {
    constexpr std::uint32_t operator()(std::uint32_t value, unsigned bits) const {
        return quantize(value, (1u << bits) - 1);
    }
};

struct Dithered {
    std::uint32_t bayer; // bayer_threshold() of the pixel's place in the window

    constexpr std::uint32_t operator()(std::uint32_t value, unsigned bits) const {
        return bits == 1 ? value >> 7 : dither(value, bits, bayer);
    }
};

// --- Formats ----------------------------------------------------------------------------------

// Some channel has fewer than 8 bits: rounding matters.
constexpr bool is_narrow(Format format) {
    return format >= Format::Rgb565 && format <= Format::Rgb5a1;
}

// The channels that are stored, a bit each, red the lowest.
constexpr unsigned stored_channels(Format format) {
    switch (format) {
    case Format::Rgbx8:
    case Format::Rgb565:
        return 0x7;
    case Format::Luminance8:
    case Format::Intensity8:
        return 0x1;
    case Format::Alpha8:
        return 0x8;
    case Format::LuminanceAlpha8:
        return 0x9;
    default:
        return 0xf;
    }
}

// The word stored for a colour; the spare byte of Rgbx8 is 255.
template <class Rounding = ToNearest>
constexpr std::uint32_t pack_pixel(Format format, std::uint32_t color, Rounding round = {}) {
    const auto level = [&](unsigned channel, unsigned bits) {
        return round(color >> 8 * channel & 255, bits);
    };
    switch (format) {
    case Format::Rgbx8:
        return color | 0xff000000u;
    case Format::Luminance8:
    case Format::Intensity8:
        return color & 255;
    case Format::Alpha8:
        return color >> 24;
    case Format::LuminanceAlpha8:
        return (color & 255) | color >> 24 << 8;
    case Format::Rgb565:
        return level(0, 5) << 11 | level(1, 6) << 5 | level(2, 5);
    case Format::Rgba4:
        return level(0, 4) << 12 | level(1, 4) << 8 | level(2, 4) << 4 | level(3, 4);
    case Format::Rgb5a1:
        return level(0, 5) << 11 | level(1, 5) << 6 | level(2, 5) << 1 | level(3, 1);
    default:
        return color;
    }
}

// The colour of a stored word; bits above the pixel's do not matter.
constexpr std::uint32_t unpack_pixel(Format format, std::uint32_t pixel) {
    constexpr std::uint32_t Gray = 0x010101, Opaque = 0xff000000;
    const auto channel = [&](unsigned shift, unsigned bits, unsigned to) {
        return widen_bits(pixel >> shift & ((1u << bits) - 1), bits) << 8 * to;
    };
    switch (format) {
    case Format::Rgbx8:
        return pixel | Opaque;
    case Format::Luminance8:
        return (pixel & 255) * Gray | Opaque;
    case Format::Alpha8:
        return pixel << 24;
    case Format::Intensity8:
        return (pixel & 255) * Gray | pixel << 24;
    case Format::LuminanceAlpha8:
        return (pixel & 255) * Gray | pixel >> 8 << 24;
    case Format::Rgb565:
        return channel(11, 5, 0) | channel(5, 6, 1) | channel(0, 5, 2) | Opaque;
    case Format::Rgba4:
        return channel(12, 4, 0) | channel(8, 4, 1) | channel(4, 4, 2) | channel(0, 4, 3);
    case Format::Rgb5a1:
        return channel(11, 5, 0) | channel(6, 5, 1) | channel(1, 5, 2) |
               ((pixel & 1) != 0 ? Opaque : 0);
    default:
        return pixel;
    }
}

// The bits of a stored word that hold the channels in `mask`; Rgbx8's spare byte always counts.
constexpr std::uint32_t pixel_bits(Format format, unsigned mask) {
    std::uint32_t channels = 0;
    for (unsigned i = 0; i < 4; ++i)
        if ((mask >> i & 1) != 0) channels |= 0xffu << 8 * i;
    return pack_pixel(format, channels);
}

// Calls visitor(format as an integral_constant), so that loops over pixels know their format.
// False: it is no plain colour format.
template <class Visitor>
bool visit_plain_color(Format format, Visitor&& visitor) {
    const auto visit = [&](auto known) {
        visitor(known);
        return true;
    };
    switch (format) {
    case Format::Rgba8:
        return visit(std::integral_constant<Format, Format::Rgba8>{});
    case Format::Rgbx8:
        return visit(std::integral_constant<Format, Format::Rgbx8>{});
    case Format::Luminance8:
        return visit(std::integral_constant<Format, Format::Luminance8>{});
    case Format::Alpha8:
        return visit(std::integral_constant<Format, Format::Alpha8>{});
    case Format::Intensity8:
        return visit(std::integral_constant<Format, Format::Intensity8>{});
    case Format::LuminanceAlpha8:
        return visit(std::integral_constant<Format, Format::LuminanceAlpha8>{});
    case Format::Rgb565:
        return visit(std::integral_constant<Format, Format::Rgb565>{});
    case Format::Rgba4:
        return visit(std::integral_constant<Format, Format::Rgba4>{});
    case Format::Rgb5a1:
        return visit(std::integral_constant<Format, Format::Rgb5a1>{});
    default:
        return false;
    }
}

} // namespace ffgpu
