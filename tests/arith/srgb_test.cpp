// The sRGB tables against the formulas of IEC 61966-2-1 and EXT_framebuffer_sRGB.

#include "model/arith/srgb.h"

#include <cmath>

#include <catch2/catch.hpp>

namespace ffgpu {
namespace {

double linear_light(unsigned code) {
    const double c = code / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

// No code lies so near to a tie that the library's pow could round it the other way.
TEST_CASE("the sRGB tables are the formula, rounded to nearest") {
    for (unsigned code = 0; code < 256; ++code) {
        CHECK(SrgbToLinear16[code] == std::floor(linear_light(code) * 65535 + 0.5));
        CHECK(SrgbToLinear8[code] == std::floor(linear_light(code) * 255 + 0.5));
    }
}

TEST_CASE("linear light becomes the nearest sRGB code, and a code's own light the code again") {
    for (unsigned code = 0; code < 256; ++code)
        REQUIRE(srgb_from_linear16(SrgbToLinear16[code]) == code);
    for (unsigned linear = 0; linear < 65536; ++linear) {
        const auto distance = [&](unsigned code) {
            return std::abs(static_cast<int>(SrgbToLinear16[code]) - static_cast<int>(linear));
        };
        const unsigned code = srgb_from_linear16(linear);
        REQUIRE((code == 0 || distance(code) <= distance(code - 1)));
        REQUIRE((code == 255 || distance(code) < distance(code + 1)));
    }
}

double encoded(double light) {
    return light < 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

TEST_CASE("light is encoded as EXT_framebuffer_sRGB has it, rounded to nearest") {
    for (unsigned linear = 0; linear < 65536; ++linear)
        REQUIRE(srgb_encoded16(linear) == std::floor(255 * encoded(linear / 65535.0) + 0.5));
    for (unsigned code = 0; code < 256; ++code)
        REQUIRE(srgb_encoded16(SrgbToLinear16[code]) == code);
}

TEST_CASE("of a colour red, green and blue are encoded, alpha is not") {
    for (std::uint32_t level = 0; level < 256; ++level) {
        const auto code = static_cast<std::uint32_t>(255 * encoded(level / 255.0) + 0.5);
        REQUIRE(srgb_encoded_rgba8(level * 0x01010101u) == (level << 24 | code * 0x010101u));
        REQUIRE(srgb_encoded_rgba8(level << 8) == code << 8);
    }
}

} // namespace
} // namespace ffgpu
