// Texel decode: from bytes in device memory to four 8-bit channels.

#pragma once

#include "model/arith/srgb.h"
#include "model/device/layout/formats.h"
#include "model/memory/pixel_format.h"
#include "model/texture/filter.h"

#include <cstddef>
#include <cstdint>

namespace ffgpu {

// The first and second colour of an S3TC block.
constexpr Rgba expand_rgb565(std::uint32_t bits) {
    return unpack_rgba8(unpack_pixel(Format::Rgb565, bits));
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
