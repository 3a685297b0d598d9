// Texels in the device's formats to and from colours and depths, a row at a time. Compressed
// formats: driver/texel/s3tc.h.

#pragma once

#include "driver/pixel/pixel_transfer.h"
#include "model/device/layout/formats.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu::gl {

// Colours are clamped to [0, 1]. Luminance and intensity are the red component (GL 1.5,
// table 3.15).
void encode_colors(Format format, std::span<const PixelColor> colors, std::byte* texels);

// As glGetTexImage sees them (GL 1.5, table 6.1): luminance and intensity are red, what a format
// lacks is 0, alpha 1.
void decode_colors(Format format, const std::byte* texels, std::span<PixelColor> colors);

// Depth16, and the upper 24 bits of Depth24Stencil8; encoding makes the stencil 0.
void encode_depths(Format format, std::span<const double> depths, std::byte* texels);
void decode_depths(Format format, const std::byte* texels, std::span<double> depths);

// Bytes r g b a of texels of an uncompressed colour format whose channels are bytes: entry i is the
// channel of byte i; ReadsAsOne: written as 255.
struct ByteChannels {
    static constexpr std::uint8_t ReadsAsOne = 5;
    std::uint8_t count = 0; // 0: its channels are not bytes
    std::uint8_t channel[4] = {};
};
ByteChannels byte_channels(Format format);

} // namespace ffgpu::gl
