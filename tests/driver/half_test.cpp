// 16-bit floats, all of them, and as the type of pixels (ARB_half_float_pixel).

#include "driver/math/half.h"
#include "driver/pixel/pack.h"
#include "driver/pixel/unpack.h"

#include <cmath>

#include <catch2/catch.hpp>

using namespace ffgpu::gl;

namespace {

Half half(unsigned bits) {
    return {static_cast<std::uint16_t>(bits)};
}

} // namespace

TEST_CASE("every 16-bit float has its value, and comes back from it") {
    for (unsigned bits = 0; bits < 65536; ++bits) {
        const double value = real_from_half(half(bits));
        const int exponent = static_cast<int>(bits >> 10 & 31), mantissa = bits & 1023;
        const double sign = (bits >> 15) != 0 ? -1 : 1;
        if (exponent == 31 && mantissa != 0) {
            REQUIRE(std::isnan(value));
            REQUIRE(std::isnan(real_from_half(half_from_real(value))));
            continue;
        }
        const double expected = exponent == 31  ? std::numeric_limits<double>::infinity()
                                : exponent == 0 ? std::ldexp(mantissa, -24)
                                                : std::ldexp(1024 + mantissa, exponent - 25);
        REQUIRE(value == sign * expected);
        REQUIRE(half_from_real(value).bits == bits);
    }
}

TEST_CASE("reals between two 16-bit floats go to the nearer, ties to the even one") {
    for (unsigned bits = 0; bits < 0x7bff; ++bits) {
        const double below = real_from_half(half(bits)), above = real_from_half(half(bits + 1));
        const double middle = (below + above) / 2;
        REQUIRE(half_from_real(middle).bits == (bits % 2 == 0 ? bits : bits + 1));
        REQUIRE(half_from_real(std::nextafter(middle, 0.0)).bits == bits);
        REQUIRE(half_from_real(std::nextafter(middle, 1e9)).bits == bits + 1);
    }
    CHECK(half_from_real(65519.99).bits == 0x7bff);
    CHECK(half_from_real(65520).bits == 0x7c00);
    CHECK(half_from_real(-1e30).bits == 0xfc00);
    CHECK(half_from_real(0x1p-26).bits == 0);
    CHECK(half_from_real(-0.0).bits == 0x8000);
}

TEST_CASE("pixels of GL_HALF_FLOAT are read and written, swapped as well") {
    const std::array<std::uint16_t, 4> elements{0x3800, 0x3c00, 0x0000, 0x3400}; // 1/2 1 0 1/4
    const PixelSource source(elements.data(), {.alignment = 1}, {1, 1, 1}, GL_RGBA, GL_HALF_FLOAT);
    PixelColor color;
    unpack_colors(source, source.row(0), &color);
    CHECK(color == PixelColor{0.5f, 1, 0, 0.25f});

    const PixelStore swapped{.swap_bytes = true, .alignment = 1};
    std::array<std::uint16_t, 4> packed{};
    const PixelDestination destination(packed.data(), swapped, {1, 1, 1}, GL_RGBA, GL_HALF_FLOAT);
    pack_colors(destination, destination.row(0), &color);
    CHECK(packed == std::array<std::uint16_t, 4>{0x0038, 0x003c, 0x0000, 0x0034});
}
