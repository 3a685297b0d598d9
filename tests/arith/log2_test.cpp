#include "model/arith/log2.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

TEST_CASE("log2_fixed8 is exact at powers of two") {
    for (int exponent = -126; exponent <= 127; ++exponent)
        CHECK(log2_fixed8(std::ldexp(1.0f, exponent)) == 256 * exponent);
}

TEST_CASE("log2_fixed8 is the floor of the logarithm of the mantissa's first 8 bits") {
    for (unsigned i = 1; i < 256; ++i) { // Entry 0 is a power of two.
        const double x = 1 + i / 256.0;
        CHECK(log2_fixed8(static_cast<float>(x)) ==
              static_cast<int>(std::floor(256 * std::log2(x))));
    }
}

TEST_CASE("log2_fixed8 never decreases and stays within 2.5 / 256 below the logarithm") {
    std::int32_t before = log2_fixed8(0x1p-3f);
    unsigned failures = 0;
    for (std::uint32_t bits = std::bit_cast<std::uint32_t>(0x1p-3f);
         bits < std::bit_cast<std::uint32_t>(0x1p3f);
         bits += 37) {
        const auto x = std::bit_cast<float>(bits);
        const std::int32_t value = log2_fixed8(x);
        const double below = 256 * std::log2(static_cast<double>(x)) - value;
        failures += value < before || below < 0 || below > 2.5;
        before = value;
    }
    CHECK(failures == 0);
}

TEST_CASE("log2_fixed8 of zero, infinity and NaN is defined") {
    CHECK(log2_fixed8(0.0f) == -127 * 256);
    CHECK(log2_fixed8(std::numeric_limits<float>::infinity()) == 128 * 256);
    CHECK(log2_fixed8(-std::numeric_limits<float>::infinity()) == 128 * 256);
    CHECK(log2_fixed8(std::numeric_limits<float>::quiet_NaN()) >= 128 * 256);
}

} // namespace
} // namespace ffgpu
