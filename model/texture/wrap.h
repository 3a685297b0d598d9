// Wrap modes: from a coordinate to one or two texels of a level, along one axis.
//
// Three steps, and only the first and the second know the mode:
//   1. fold, in binary32: the coordinate into [0, 1] or little more. The level does not matter yet.
//   2. scale to the level in fixed point with 8 fraction bits, clamp to the mode's range.
//   3. texel indices; at most one step outside the level, resolved by two constants.

#pragma once

#include "model/device/registers/texture.h"

#include <cstdint>

namespace ffgpu {

enum class Fold : std::uint8_t { Repeat, Mirror, Clamp, MirrorClamp };

// A wrap mode as constants. Clamps are raw values with 8 fraction bits.
struct WrapRule {
    Fold fold = Fold::Repeat;
    bool wraps = false;     // An index past one edge comes in at the other.
    bool border = false;    // Indices -1 and size can occur and mean border texels.
    std::int32_t low = 0;   // The texel coordinate is clamped to low ...
    std::int32_t above = 0; // ... and to 256 size + above.

    bool operator==(const WrapRule&) const = default;
};

// GL_CLAMP's coordinate stays in [0, 1]: a linear filter then reaches the border, a nearest one
// never (GL 1.5, 3.8.7 and the remark below equation 3.19 on s = 1): without a border, index `size`
// is the last texel.
constexpr WrapRule wrap_rule(Wrap wrap, bool linear) {
    constexpr std::int32_t Half = 128;
    switch (wrap) {
    case Wrap::Repeat:
        return {Fold::Repeat, true, false, 0, 0};
    case Wrap::MirroredRepeat:
        return {Fold::Mirror, false, false, Half, -Half};
    case Wrap::Clamp:
        return {Fold::Clamp, false, linear, 0, 0};
    case Wrap::ClampToEdge:
        return {Fold::Clamp, false, false, Half, -Half};
    case Wrap::ClampToBorder:
        return {Fold::Clamp, false, true, -Half, Half};
    case Wrap::MirrorClamp:
        return {Fold::MirrorClamp, false, linear, Half, 0};
    case Wrap::MirrorClampToEdge:
        return {Fold::MirrorClamp, false, false, Half, -Half};
    case Wrap::MirrorClampToBorder:
        return {Fold::MirrorClamp, false, true, Half, Half};
    }
    return {};
}

// floor() of a binary32 number below 2^23 in magnitude.
constexpr float floor_small(float x) {
    const auto whole = static_cast<float>(static_cast<std::int32_t>(x));
    return whole > x ? whole - 1 : whole;
}

// x - floor(x), in [0, 1]. From 2^23 on, infinity included, every number is whole: 0.
constexpr float fraction(float x) {
    const float magnitude = x < 0 ? -x : x;
    return magnitude < 0x1p23f ? x - floor_small(x) : 0.0f;
}

// Step 1. `s` is not NaN; `extent` is the coordinate of the far edge, 1, or the size if coordinates
// count texels. The clamping modes leave a margin of 1 for the border.
constexpr float fold_coordinate(Fold fold, float s, float extent) {
    if (fold == Fold::Repeat) return fraction(s);
    if (fold == Fold::Mirror) {
        const float twice = 2 * fraction(s * 0.5f);
        const float back = 2 - twice;
        return twice < back ? twice : back;
    }
    if (fold == Fold::MirrorClamp && s < 0) s = -s;
    const float most = extent + 1;
    const float at_least = s < -1 ? -1 : s;
    return at_least > most ? most : at_least;
}

// To the nearest integer, ties to even, as the rounding mode of the processors' conversion does.
// |x| < 2^31. The sum leaves no fraction bits in a binary64 number.
constexpr std::int32_t round_to_int(float x) {
    constexpr double Shift = 0x1.8p52;
    return static_cast<std::int32_t>((static_cast<double>(x) + Shift) - Shift);
}

// Step 2. `scale` is 256 texels of the level for each unit of the coordinate.
constexpr std::int32_t
texel_coordinate(float folded, float scale, std::int32_t size, const WrapRule& rule) {
    const std::int32_t raw = round_to_int(folded * scale);
    const std::int32_t high = 256 * size + rule.above;
    const std::int32_t at_least = raw < rule.low ? rule.low : raw;
    return at_least > high ? high : at_least;
}

// Step 3 for one index, which lies in [-1, size + 1].
constexpr std::int32_t resolve_index(std::int32_t index, std::int32_t size, const WrapRule& rule) {
    const std::int32_t last = size - 1 + rule.border;
    if (index < 0) return rule.wraps ? size - 1 : -1;
    if (index > last) return rule.wraps ? 0 : last;
    return index;
}

// The texels of one axis and the second's weight in 256ths. Nearest: both equal, weight 0.
struct AxisTexels {
    std::int32_t first = 0, second = 0;
    std::uint32_t weight = 0;
};

constexpr AxisTexels
nearest_texel(std::int32_t coordinate, std::int32_t size, const WrapRule& rule) {
    const std::int32_t index = resolve_index(coordinate >> 8, size, rule);
    return {index, index, 0};
}

constexpr AxisTexels
linear_texels(std::int32_t coordinate, std::int32_t size, const WrapRule& rule) {
    const std::int32_t from_centre = coordinate - 128;
    const std::int32_t first = from_centre >> 8;
    return {resolve_index(first, size, rule),
            resolve_index(first + 1, size, rule),
            static_cast<std::uint32_t>(from_centre & 0xff)};
}

} // namespace ffgpu
