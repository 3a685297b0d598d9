// The sRGB table against the formula of IEC 61966-2-1.

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

} // namespace
} // namespace ffgpu
