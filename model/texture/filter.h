// The filter's arithmetic: integer interpolation with 8-bit weights.

#pragma once

#include <array>
#include <cstdint>

namespace ffgpu {

// Channels r g b a, each 0 .. 255.
using Rgba = std::array<std::uint8_t, 4>;

// (a (256 - w) + b w) / 256, rounded to nearest, halves up; w in 0 .. 255. a == b gives a.
constexpr std::uint8_t lerp8w(unsigned a, unsigned b, unsigned weight) {
    return static_cast<std::uint8_t>((a * (256 - weight) + b * weight + 128) >> 8);
}

constexpr Rgba lerp8w(const Rgba& a, const Rgba& b, unsigned weight) {
    Rgba result{};
    for (unsigned channel = 0; channel < 4; ++channel)
        result[channel] = lerp8w(a[channel], b[channel], weight);
    return result;
}

} // namespace ffgpu
