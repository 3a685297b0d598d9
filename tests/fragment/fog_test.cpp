#include "model/arith/exp2.h"
#include "model/fragment/fog.h"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

using namespace ffgpu;

namespace {

constexpr float Infinity = std::numeric_limits<float>::infinity();
constexpr float NaN = std::numeric_limits<float>::quiet_NaN();

FogCurve linear(float start, float end) {
    return compile_fog({.mode = FogMode::Linear, .start = start, .end = end});
}

} // namespace

TEST_CASE("2^-x is within 3 units of 2^17 of the real function, and exact at whole numbers") {
    std::uint32_t last = 1u << 17;
    for (std::uint32_t fraction = 0; fraction < 65536; ++fraction) {
        const std::uint32_t mantissa = exp2_negative_mantissa(fraction);
        const double exact = std::exp2(17.0 - fraction / 65536.0);
        if (std::abs(mantissa - exact) > 3.0) REQUIRE(mantissa == exact);
        if (mantissa > last) REQUIRE(mantissa <= last); // never increases
        last = mantissa;
    }
    REQUIRE(exp2_negative_mantissa(0) == 1u << 17);
    REQUIRE(last > 1u << 16);
    for (std::uint32_t i = 0; i < 8; ++i)
        REQUIRE(exp2_negative_unorm8(i << 16) == (255u + (1u << i) / 2) >> i);
}

TEST_CASE("Linear fog falls from start to end and is clamped beyond them") {
    const FogCurve fog = linear(10, 20);
    REQUIRE(fog_factor(fog, 5) == 255);
    REQUIRE(fog_factor(fog, 10) == 255);
    REQUIRE(fog_factor(fog, 15) == 128); // 127.5, ties up
    REQUIRE(fog_factor(fog, 20) == 0);
    REQUIRE(fog_factor(fog, 25) == 0);
    REQUIRE(fog_factor(fog, Infinity) == 0);
    REQUIRE(fog_factor(fog, -Infinity) == 255);
}

TEST_CASE("Linear fog whose start is its end is a step at the end") {
    const FogCurve fog = linear(4, 4);
    REQUIRE(fog_factor(fog, std::nextafter(4.0f, 0.0f)) == 255);
    REQUIRE(fog_factor(fog, 4) == 0);
    REQUIRE(fog_factor(fog, std::nextafter(4.0f, 5.0f)) == 0);
}

TEST_CASE("Linear fog may run backwards") {
    const FogCurve fog = linear(20, 10);
    REQUIRE(fog_factor(fog, 10) == 0);
    REQUIRE(fog_factor(fog, 20) == 255);
}

TEST_CASE("A coordinate that is not a number is all fog") {
    for (const FogMode mode : {FogMode::Linear, FogMode::Exp, FogMode::Exp2}) {
        const FogCurve fog = compile_fog({.mode = mode});
        REQUIRE(fog_factor(fog, NaN) == 0);
    }
}

TEST_CASE("Exponential fog is within one step of the real curve, to nearest almost always") {
    for (const FogMode mode : {FogMode::Exp, FogMode::Exp2}) {
        const FogCurve fog = compile_fog({.mode = mode, .density = 0.37f});
        unsigned different = 0, count = 0;
        for (float c = 0; c < 30; c += 0.0037f, ++count) {
            const double power = 0.37f * double{c};
            const double f = std::exp(mode == FogMode::Exp ? -power : -power * power);
            const int nearest = static_cast<int>(std::floor(f * 255 + 0.5));
            const int factor = fog_factor(fog, c);
            REQUIRE(std::abs(factor - nearest) <= 1);
            if (factor != nearest) ++different;
        }
        REQUIRE(different < count / 100);
    }
}

TEST_CASE("Exponential fog ends at both clamps") {
    const FogCurve fog = compile_fog({.mode = FogMode::Exp, .density = 1});
    REQUIRE(fog_factor(fog, 0) == 255);
    REQUIRE(fog_factor(fog, -3) == 255);
    REQUIRE(fog_factor(fog, 1e30f) == 0);
    REQUIRE(fog_factor(fog, Infinity) == 0);
    // 255 e^-c = 1/2
    REQUIRE(fog_factor(fog, 6.22f) == 1);
    REQUIRE(fog_factor(fog, 6.25f) == 0);
    REQUIRE(fog_factor(compile_fog({.mode = FogMode::Exp2, .density = 1}), -0.5f) ==
            fog_factor(compile_fog({.mode = FogMode::Exp2, .density = 1}), 0.5f));
}

TEST_CASE("Fog mixes with one rounding and leaves alpha, for every factor, colour and fog colour") {
    FogCurve fog = compile_fog({.mode = FogMode::Linear});
    for (unsigned fog_color = 0; fog_color < 256; ++fog_color) {
        fog.color = {static_cast<std::uint8_t>(fog_color), 0, 255, 99};
        for (unsigned factor = 0; factor < 256; ++factor)
            for (unsigned color = 0; color < 256; ++color) {
                const auto c = static_cast<std::uint8_t>(color);
                const PixelColor result =
                    apply_fog(fog, static_cast<std::uint8_t>(factor), {c, c, c, 7});
                const unsigned sum = factor * color + (255 - factor) * fog_color;
                if (result[0] != (2 * sum + 255) / 510) REQUIRE(result[0] == (2 * sum + 255) / 510);
                if (result[3] != 7) REQUIRE(int(result[3]) == 7);
            }
    }
    SUCCEED();
}
