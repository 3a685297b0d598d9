// 16-bit floats (ARB_half_float_pixel): a sign, 5 bits of exponent with a bias of 15, 10 of
// mantissa.

#pragma once

#include <bit>
#include <cstdint>
#include <limits>

namespace ffgpu::gl {

struct Half {
    std::uint16_t bits = 0;
};

// Exact.
constexpr double real_from_half(Half half) {
    const unsigned exponent = half.bits >> 10 & 31, mantissa = half.bits & 1023;
    double magnitude = 0;
    if (exponent == 31) {
        magnitude = mantissa != 0 ? std::numeric_limits<double>::quiet_NaN()
                                  : std::numeric_limits<double>::infinity();
    } else if (exponent == 0) {
        magnitude = mantissa * 0x1p-24;
    } else {
        const std::uint64_t bits = std::uint64_t{exponent + 1008} << 52 | std::uint64_t{mantissa}
                                                                              << 42;
        magnitude = std::bit_cast<double>(bits);
    }
    return (half.bits >> 15) != 0 ? -magnitude : magnitude;
}

// To the nearest, ties to even; what is too large becomes infinity, NaN stays one.
constexpr Half half_from_real(double real) {
    constexpr std::uint16_t Infinity = 0x7c00, Nan = 0x7e00;
    const auto bits = std::bit_cast<std::uint64_t>(real);
    const auto sign = static_cast<std::uint16_t>(bits >> 48 & 0x8000);
    if (real != real) return {static_cast<std::uint16_t>(sign | Nan)};
    const int exponent = static_cast<int>(bits >> 52 & 2047) - 1023;
    if (exponent > 15) return {static_cast<std::uint16_t>(sign | Infinity)};
    if (exponent < -25) return {sign};
    // The result's mantissa ends where 2^-24 or the tenth bit is; the rest rounds it.
    const std::uint64_t significand = (bits & 0xfffffffffffff) | std::uint64_t{1} << 52;
    const int dropped = exponent < -14 ? 42 + (-14 - exponent) : 42;
    const std::uint64_t kept = significand >> dropped;
    const std::uint64_t rest = significand & ((std::uint64_t{1} << dropped) - 1);
    const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
    const bool up = rest > half || (rest == half && kept % 2 == 1);
    // The leading bit adds one to the exponent of normal numbers; so does a carry.
    const std::uint64_t biased = exponent < -14 ? 0 : static_cast<std::uint64_t>(exponent + 14);
    return {static_cast<std::uint16_t>(sign | ((biased << 10) + kept + (up ? 1 : 0)))};
}

} // namespace ffgpu::gl
