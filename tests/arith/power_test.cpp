// log2, exp2 and power keep within the error bounds that docs/arithmetic/geometry.md states.

#include "model/arith/power.h"

#include <cmath>
#include <limits>
#include <random>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

// libm is good enough to measure by: its error is a thousandth of the bounds.
TEST_CASE("log2 is within 2^-22 near 1 and 2^-22 of its magnitude elsewhere") {
    std::mt19937 random(1);
    for (int i = 0; i < 400000; ++i) {
        const auto bits = 0x00800000u + static_cast<std::uint32_t>(random()) % 0x7f000000u;
        const float x = std::bit_cast<float>(bits);
        const double expected = std::log2(double{x});
        const double bound = 0x1p-22 * std::max(1.0, std::fabs(expected));
        REQUIRE(std::fabs(log2_binary32(x) - expected) <= bound);
    }
}

TEST_CASE("log2 is exact at powers of two") {
    for (int e = -126; e <= 127; ++e)
        CHECK(log2_binary32(std::ldexp(1.0f, e)) == static_cast<float>(e));
}

TEST_CASE("log2 loses nothing next to 1") {
    for (int i = 1; i < 60000; ++i) {
        const float below = 1.0f - static_cast<float>(i) * 0x1p-24f;
        const float above = 1.0f + static_cast<float>(i) * 0x1p-23f;
        const double low = std::log2(double{below}), high = std::log2(double{above});
        REQUIRE(std::fabs(log2_binary32(below) - low) <= 0x1p-21 * std::fabs(low));
        REQUIRE(std::fabs(log2_binary32(above) - high) <= 0x1p-21 * std::fabs(high));
    }
}

TEST_CASE("exp2 is within 2^-22 of its value") {
    std::mt19937 random(2);
    for (int i = 0; i < 400000; ++i) {
        const float v = static_cast<float>(random() >> 8) * (253.0f / 0x1p24f) - 126.0f;
        const double expected = std::exp2(double{v});
        REQUIRE(std::fabs(exp2_binary32(v) - expected) <= 0x1p-22 * expected);
    }
}

TEST_CASE("exp2 of an integer is exact") {
    for (int n = -126; n <= 127; ++n)
        CHECK(exp2_binary32(static_cast<float>(n)) == std::ldexp(1.0f, n));
}

TEST_CASE("power is within 2^-15 of its value for highlights") {
    std::mt19937 random(3);
    for (int i = 0; i < 200000; ++i) {
        const float x = static_cast<float>(random() >> 8) * 0x1p-24f;
        const float y = static_cast<float>(random() >> 8) * (128.0f / 0x1p24f);
        const double expected = std::pow(double{x}, double{y});
        REQUIRE(std::fabs(power(x, y) - expected) <= 0x1p-15 * expected + 0x1p-126);
    }
}

TEST_CASE("power has a defined outcome for every input") {
    constexpr float Nan = std::numeric_limits<float>::quiet_NaN();
    constexpr float Infinity = std::numeric_limits<float>::infinity();
    CHECK(power(0, 0) == 1);
    CHECK(power(-3, 0) == 1);
    CHECK(power(Nan, 0) == 1);
    CHECK(power(0, 0.01f) == 0);
    CHECK(power(-1, 2) == 0);
    CHECK(power(Nan, 2) == 0);
    CHECK(power(1, 128) == 1);
    CHECK(power(0.5f, 127) == 0);
    CHECK(power(0.5f, 126) == 0x1p-126f);
    CHECK(power(2, 10) == 1024);
    CHECK(power(Infinity, 128) == 0x1p127f);
    CHECK(power(0.5f, Nan) == 0);
}

} // namespace
} // namespace ffgpu
