// Formats of texels and pixels in device memory.
//
// Rows run from bottom to top, as in OpenGL: row 0 of a colour target is the lowest row of the
// window. Multi-byte elements are little endian.

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu {

using DeviceAddress = std::uint32_t;

enum class Format : std::uint8_t {
    None,
    Rgba8,           // bytes r g b a
    Rgbx8,           // bytes r g b and one that reads as 255
    Luminance8,      // r = g = b = l, a = 255
    Alpha8,          // r = g = b = 0
    Intensity8,      // r = g = b = a = i
    LuminanceAlpha8, // bytes l a
    Rgb565,          // red in the top five bits of 16
    Rgba4,           // red in the top four bits of 16, alpha in the lowest
    Rgb5a1,          // red in the top five bits of 16, alpha in the lowest
    Dxt1Rgb,         // S3TC blocks of 4x4 texels
    Dxt1Rgba,
    Dxt3,
    Dxt5,
    Fxt1Rgb, // FXT1 blocks of 8x4 texels
    Fxt1Rgba,
    Depth16,         // 16-bit unsigned, 65535 is the far plane
    Depth24Stencil8, // 32 bits: depth in the upper 24, stencil in the lower 8
    Stencil8,        // only as the source of an image draw
    Bitmap,          // only as the source of an image draw: one bit a pixel, lowest bit first
    Count
};

struct FormatInfo {
    std::string_view name;
    std::uint8_t block_width; // In texels; 1 but for compressed formats.
    std::uint8_t block_height;
    std::uint8_t block_bytes; // 0 for Bitmap.
    bool is_depth;
};

constexpr std::array<FormatInfo, static_cast<std::size_t>(Format::Count)> FormatTable{{
    {"none", 1, 1, 0, false},
    {"rgba8", 1, 1, 4, false},
    {"rgbx8", 1, 1, 4, false},
    {"luminance8", 1, 1, 1, false},
    {"alpha8", 1, 1, 1, false},
    {"intensity8", 1, 1, 1, false},
    {"luminance_alpha8", 1, 1, 2, false},
    {"rgb565", 1, 1, 2, false},
    {"rgba4", 1, 1, 2, false},
    {"rgb5a1", 1, 1, 2, false},
    {"dxt1_rgb", 4, 4, 8, false},
    {"dxt1_rgba", 4, 4, 8, false},
    {"dxt3", 4, 4, 16, false},
    {"dxt5", 4, 4, 16, false},
    {"fxt1_rgb", 8, 4, 16, false},
    {"fxt1_rgba", 8, 4, 16, false},
    {"depth16", 1, 1, 2, true},
    {"depth24_stencil8", 1, 1, 4, true},
    {"stencil8", 1, 1, 1, false},
    {"bitmap", 1, 1, 0, false},
}};

constexpr const FormatInfo& format_info(Format format) {
    return FormatTable[static_cast<std::size_t>(format)];
}

// Uncompressed and with colour: what colour targets and copies of colours may be of. (A format from
// a file may be none of the list.)
constexpr bool is_plain_color(Format format) {
    return format >= Format::Rgba8 && format <= Format::Rgb5a1;
}

// What depth targets and copies of depths may be of.
constexpr bool is_depth_target(Format format) {
    return format == Format::Depth16 || format == Format::Depth24Stencil8;
}

// Bytes of one row of blocks of an image `width` texels wide. Rows are not padded.
constexpr std::uint32_t row_bytes(Format format, std::uint32_t width) {
    if (format == Format::Bitmap) return (width + 7) / 8;
    const FormatInfo& info = format_info(format);
    return (width + info.block_width - 1) / info.block_width * info.block_bytes;
}

constexpr std::uint32_t block_rows(Format format, std::uint32_t height) {
    const std::uint32_t block = format_info(format).block_height;
    return (height + block - 1) / block;
}

} // namespace ffgpu
