// exp2 and log2 in binary32: one small table each, and a short polynomial around its entries.
//
//     log2(x) = e + L[i] + z (K1 + z (K2 + z K3)),   z = (m - c) R[i],   c = 1 + i / 64
//         x = m 2^e with m in [1, 2); i is m - 1 rounded to 1/64, so that |m - c| <= 1/128;
//         L[i] = log2(c), R[i] = 1 / c
//     exp2(v) = 2^n T[j] (1 + r (E1 + r E2)),        v = n + j / 64 + r,   |r| <= 1/128
//         T[j] = 2^(j / 64)
//
// Entries are the real numbers rounded to binary32; each operation is one binary32 operation, in
// the order written. log2(1) = 0 and exp2(integer) are exact. docs/arithmetic/geometry.md has the
// error bounds, tests/arith holds the functions to them.

#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace ffgpu {

constexpr unsigned LogExpSegments = 64;

namespace log_exp {

constexpr double Ln2 = 0.693147180559945309417232121458;

// The series below are summed in binary64 by the compiler: IEEE arithmetic, the same everywhere.
constexpr double log2_series(double x) { // x in [1, 2]
    const double z = (x - 1) / (x + 1), z2 = z * z;
    double power = z, sum = 0;
    for (int k = 1; k < 60; k += 2, power *= z2)
        sum += power / k;
    return 2 * sum / Ln2;
}

constexpr double exp2_series(double x) { // x in [0, 1]
    double term = 1, sum = 0;
    for (int k = 1; k < 30; ++k) {
        sum += term;
        term *= x * Ln2 / k;
    }
    return sum;
}

template <std::size_t Size, class Function>
constexpr std::array<float, Size> tabulate(Function&& function) {
    std::array<float, Size> table{};
    for (std::size_t i = 0; i < Size; ++i)
        table[i] = static_cast<float>(function(static_cast<double>(i) / LogExpSegments));
    return table;
}

inline constexpr auto Log2 =
    tabulate<LogExpSegments + 1>([](double x) { return log2_series(1 + x); });
inline constexpr auto Reciprocal =
    tabulate<LogExpSegments + 1>([](double x) { return 1 / (1 + x); });
inline constexpr auto Exp2 = tabulate<LogExpSegments>([](double x) { return exp2_series(x); });

constexpr float K1 = static_cast<float>(1 / Ln2);
constexpr float K2 = static_cast<float>(-1 / (2 * Ln2));
constexpr float K3 = static_cast<float>(1 / (3 * Ln2));
constexpr float E1 = static_cast<float>(Ln2);
constexpr float E2 = static_cast<float>(Ln2 * Ln2 / 2);

constexpr float Step = 1.0f / LogExpSegments;
constexpr float RoundToInteger = 12582912.0f; // 1.5 * 2^23: x + it has x's integer in its low bits

} // namespace log_exp

// x: positive, not subnormal, finite.
constexpr float log2_binary32(float x) {
    using namespace log_exp;
    const auto bits = std::bit_cast<std::int32_t>(x);
    const std::int32_t exponent = (bits >> 23) - 127;
    const std::int32_t mantissa = bits & 0x7fffff;
    const std::int32_t i = (mantissa + (1 << 16)) >> 17;
    const float m = std::bit_cast<float>(mantissa | 0x3f800000);
    const float c = static_cast<float>(i) * Step + 1.0f;
    const float z = (m - c) * Reciprocal[static_cast<unsigned>(i)];
    const float head = static_cast<float>(exponent) + Log2[static_cast<unsigned>(i)];
    return head + z * (K1 + z * (K2 + z * K3));
}

// v in [-126, 127].
constexpr float exp2_binary32(float v) {
    using namespace log_exp;
    const float biased = v * LogExpSegments + RoundToInteger;
    const std::int32_t k =
        std::bit_cast<std::int32_t>(biased) - std::bit_cast<std::int32_t>(RoundToInteger);
    const float r = v - static_cast<float>(k) * Step;
    const float table = Exp2[static_cast<unsigned>(k) % LogExpSegments];
    const float scale = std::bit_cast<float>(((k >> 6) + 127) << 23);
    return table * (1.0f + r * (E1 + r * E2)) * scale;
}

} // namespace ffgpu
