// The range rule: which numbers enter the fragment path, so that nothing on it becomes subnormal,
// infinite or NaN (docs/arithmetic/raster.md has the proof).

#pragma once

#include <bit>
#include <cstdint>

namespace ffgpu {

// An attribute is 0, or of a magnitude in [LeastValue, LargestValue).
constexpr float LeastValue = 0x1p-60f;
constexpr float LargestValue = 0x1p60f;

// Whatever is outside, NaN included, becomes 0.
constexpr float in_range(float value) {
    const float magnitude = value < 0 ? -value : value;
    return magnitude >= LeastValue && magnitude < LargestValue ? value : 0.0f;
}

// Fog coordinates and fog's own numbers: small ones become 0, large ones the largest.
constexpr float LeastFog = 0x1p-30f;
constexpr float LargestFog = 0x1p30f;

constexpr float in_fog_range(float value) {
    const float magnitude = value < 0 ? -value : value;
    if (!(magnitude >= LeastFog)) return 0;
    return magnitude <= LargestFog ? value : value < 0 ? -LargestFog : LargestFog;
}

// Zero or a normal number.
constexpr bool is_ordinary(float value) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t exponent = bits >> 23 & 0xff;
    return (exponent != 0 && exponent != 0xff) || (bits & 0x7fffffff) == 0;
}

} // namespace ffgpu
