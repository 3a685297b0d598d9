// GL's conversions between numbers (GL 1.5, table 2.6 and 6.1.2). NaN counts as 0.

#pragma once

#include "driver/gl_types.h"

#include <cstdint>
#include <limits>

namespace ffgpu::gl {

// To [0, 1].
constexpr double clamp_unit(double value) {
    return value >= 1 ? 1 : value > 0 ? value : 0;
}

constexpr float clamp_unit(float value) {
    return value >= 1 ? 1.0f : value > 0 ? value : 0.0f;
}

// A colour component, normal or depth given as an integer: the type's range to [-1, 1].
constexpr float normalized_from_int(GLint value) {
    return static_cast<float>((2.0 * value + 1.0) / 4294967295.0);
}

// Nearest integer, halves away from zero; beyond the type's range its nearest end.
constexpr GLint round_to_int(double value) {
    constexpr double Max = std::numeric_limits<GLint>::max();
    constexpr double Min = std::numeric_limits<GLint>::min();
    if (!(value == value)) return 0;
    if (value >= Max) return std::numeric_limits<GLint>::max();
    if (value <= Min) return std::numeric_limits<GLint>::min();
    return static_cast<GLint>(value < 0 ? value - 0.5 : value + 0.5);
}

// The way back: 1 to the most positive integer, -1 to the most negative.
constexpr GLint int_from_normalized(double value) {
    return round_to_int((4294967295.0 * value - 1.0) / 2.0);
}
static_assert(int_from_normalized(1) == std::numeric_limits<GLint>::max());
static_assert(int_from_normalized(-1) == std::numeric_limits<GLint>::min());

// [0, 1] to 0 .. 2^bits - 1, nearest; halves away from zero.
constexpr std::uint32_t unorm(double value, unsigned bits) {
    const double max = static_cast<double>((std::uint64_t{1} << bits) - 1);
    return static_cast<std::uint32_t>(clamp_unit(value) * max + 0.5);
}

} // namespace ffgpu::gl
