#include "model/memory/pixel_format.h"

#include "model/base/check.h"

#include <algorithm>

namespace ffgpu {
namespace {

// Reads or writes one pixel after the other: `each(index, address)`.
template <unsigned Bytes, class Count, class Address, class Each>
void for_pixels(Count count, Address* at, Each&& each) {
    for (std::size_t i = 0; i < count; ++i, at += Bytes)
        each(i, at);
}

constexpr std::uint32_t gray(std::uint32_t value) {
    return value * 0x010101u;
}

constexpr std::uint32_t rgba8_from_rgba4(std::uint32_t pixel) {
    return widen_bits(pixel >> 12, 4) | widen_bits(pixel >> 8 & 15, 4) << 8 |
           widen_bits(pixel >> 4 & 15, 4) << 16 | widen_bits(pixel & 15, 4) << 24;
}

constexpr std::uint32_t rgba8_from_rgb5a1(std::uint32_t pixel) {
    return widen_bits(pixel >> 11, 5) | widen_bits(pixel >> 6 & 31, 5) << 8 |
           widen_bits(pixel >> 1 & 31, 5) << 16 | ((pixel & 1) != 0 ? 0xff000000u : 0u);
}

constexpr std::uint16_t rgba4_from_rgba8(std::uint32_t color) {
    const auto level = [&](unsigned shift) { return quantize(color >> shift & 255, 15); };
    return static_cast<std::uint16_t>(level(0) << 12 | level(8) << 8 | level(16) << 4 | level(24));
}

constexpr std::uint16_t rgb5a1_from_rgba8(std::uint32_t color) {
    const auto level = [&](unsigned shift) { return quantize(color >> shift & 255, 31); };
    return static_cast<std::uint16_t>(level(0) << 11 | level(8) << 6 | level(16) << 1 |
                                      color >> 31);
}

} // namespace

void load_rgba8(Format format, const std::byte* from, std::span<std::uint32_t> colors) {
    const auto load8 = [&](auto&& convert) {
        for_pixels<1>(colors.size(), from, [&](std::size_t i, const std::byte* at) {
            colors[i] = convert(load_word<std::uint8_t>(at));
        });
    };
    const auto load16 = [&](auto&& convert) {
        for_pixels<2>(colors.size(), from, [&](std::size_t i, const std::byte* at) {
            colors[i] = convert(load_word<std::uint16_t>(at));
        });
    };
    const auto load32 = [&](std::uint32_t set_bits) {
        for_pixels<4>(colors.size(), from, [&](std::size_t i, const std::byte* at) {
            colors[i] = load_word<std::uint32_t>(at) | set_bits;
        });
    };
    switch (format) {
    case Format::Rgba8:
        return load32(0);
    case Format::Rgbx8:
        return load32(0xff000000u);
    case Format::Luminance8:
        return load8([](std::uint32_t l) { return gray(l) | 0xff000000u; });
    case Format::Alpha8:
        return load8([](std::uint32_t a) { return a << 24; });
    case Format::Intensity8:
        return load8([](std::uint32_t i) { return gray(i) | i << 24; });
    case Format::LuminanceAlpha8:
        return load16([](std::uint32_t p) { return gray(p & 255) | p >> 8 << 24; });
    case Format::Rgb565:
        return load16(rgba8_from_rgb565);
    case Format::Rgba4:
        return load16(rgba8_from_rgba4);
    case Format::Rgb5a1:
        return load16(rgba8_from_rgb5a1);
    default:
        check(false, "load_rgba8: not a plain colour format");
    }
}

void store_rgba8(Format format, std::span<const std::uint32_t> colors, std::byte* to) {
    const auto store8 = [&](unsigned shift) {
        for_pixels<1>(colors.size(), to, [&](std::size_t i, std::byte* at) {
            store_word(at, static_cast<std::uint8_t>(colors[i] >> shift));
        });
    };
    const auto store16 = [&](auto&& convert) {
        for_pixels<2>(colors.size(), to, [&](std::size_t i, std::byte* at) {
            store_word(at, static_cast<std::uint16_t>(convert(colors[i])));
        });
    };
    const auto store32 = [&](std::uint32_t set_bits) {
        for_pixels<4>(colors.size(), to, [&](std::size_t i, std::byte* at) {
            store_word(at, colors[i] | set_bits);
        });
    };
    switch (format) {
    case Format::Rgba8:
        return store32(0);
    case Format::Rgbx8:
        return store32(0xff000000u);
    case Format::Luminance8:
    case Format::Intensity8:
        return store8(0);
    case Format::Alpha8:
        return store8(24);
    case Format::LuminanceAlpha8:
        return store16([](std::uint32_t c) { return (c & 255) | c >> 24 << 8; });
    case Format::Rgb565:
        return store16([](std::uint32_t c) { return rgb565_from_rgba8(c); });
    case Format::Rgba4:
        return store16(rgba4_from_rgba8);
    case Format::Rgb5a1:
        return store16(rgb5a1_from_rgba8);
    default:
        check(false, "store_rgba8: not a plain colour format");
    }
}

std::uint32_t depth_units(Format format, float depth) {
    const std::uint32_t maximum = format == Format::Depth16 ? 0xffff : Depth24Maximum;
    if (!(depth > 0.0f)) return 0;
    if (depth >= 1.0f) return maximum;
    return static_cast<std::uint32_t>(static_cast<double>(depth) * maximum + 0.5);
}

void load_depth24(Format format, const std::byte* from, std::span<std::uint32_t> depths) {
    if (format == Format::Depth16) {
        for_pixels<2>(depths.size(), from, [&](std::size_t i, const std::byte* at) {
            depths[i] = depth24_from_depth16(load_word<std::uint16_t>(at));
        });
        return;
    }
    check(format == Format::Depth24Stencil8, "load_depth24: not a depth format");
    for_pixels<4>(depths.size(), from, [&](std::size_t i, const std::byte* at) {
        depths[i] = load_word<std::uint32_t>(at) >> 8;
    });
}

void store_depth24(Format format, std::span<const std::uint32_t> depths, std::byte* to) {
    if (format == Format::Depth16) {
        for_pixels<2>(depths.size(), to, [&](std::size_t i, std::byte* at) {
            store_word(at, static_cast<std::uint16_t>(depth16_from_depth24(depths[i])));
        });
        return;
    }
    check(format == Format::Depth24Stencil8, "store_depth24: not a depth format");
    for_pixels<4>(depths.size(), to, [&](std::size_t i, std::byte* at) {
        store_word(at, depths[i] << 8 | (load_word<std::uint32_t>(at) & 255));
    });
}

bool surface_fits(const Surface& surface, std::uint64_t memory_size) {
    if (!is_plain_color(surface.format) && !is_depth_target(surface.format)) return false;
    if (surface.width == 0 || surface.height == 0) return false;
    if (surface.samples != 1 && surface.samples != MaxSamples) return false;
    const std::uint64_t row = row_bytes(surface.format, surface.width);
    if (surface.height > 1 && surface.stride < row) return false;
    // The last row need not reach to the next.
    return surface.address + surface.bytes() - surface.stride + row <= memory_size;
}

} // namespace ffgpu
