// Texel decode: from bytes in device memory to four 8-bit channels.

#pragma once

#include "model/arith/srgb.h"
#include "model/device/formats.h"
#include "model/texture/filter.h"

#include <cstddef>
#include <cstdint>

namespace ffgpu {

// Device memory is little endian.
constexpr std::uint32_t load16(const std::byte* at) {
    return std::to_integer<std::uint32_t>(at[0]) | std::to_integer<std::uint32_t>(at[1]) << 8;
}
constexpr std::uint32_t load32(const std::byte* at) {
    return load16(at) | load16(at + 2) << 16;
}

// Wider by repeating the leading bits: 0 stays 0 and all ones become 255.
constexpr std::uint8_t widen4(std::uint32_t bits) {
    return static_cast<std::uint8_t>(bits << 4 | bits);
}
constexpr std::uint8_t widen5(std::uint32_t bits) {
    return static_cast<std::uint8_t>(bits << 3 | bits >> 2);
}
constexpr std::uint8_t widen6(std::uint32_t bits) {
    return static_cast<std::uint8_t>(bits << 2 | bits >> 4);
}

constexpr Rgba expand_rgb565(std::uint32_t bits) {
    return {widen5(bits >> 11 & 31), widen6(bits >> 5 & 63), widen5(bits & 31), 255};
}

// One texel of an uncompressed colour format.
Rgba decode_color_texel(Format format, const std::byte* at);

// sRGB codes as linear light; alpha is linear already.
constexpr Rgba linear_from_srgb(const Rgba& color) {
    return {SrgbToLinear8[color[0]], SrgbToLinear8[color[1]], SrgbToLinear8[color[2]], color[3]};
}

// One texel of a depth format as 24 bits: 16 are widened by repeating the leading 8.
std::uint32_t decode_depth_texel(Format format, const std::byte* at);

} // namespace ffgpu
