// The driver's arithmetic: angles, matrices, conversions.

#include "driver/math/conversion.h"
#include "driver/math/matrix.h"
#include "driver/math/sin_cos.h"

#include <cmath>
#include <cstring>

#include <catch2/catch.hpp>

namespace ffgpu::gl {

TEST_CASE("Sine and cosine are exact at multiples of 90 degrees and close everywhere") {
    const double quarters[5][2] = {{0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 1}};
    for (int i = -8; i <= 8; ++i) {
        const auto& expected = quarters[i & 3];
        const SinCos result = sin_cos_degrees(90.0 * i);
        CHECK(result.sin == expected[0]);
        CHECK(result.cos == expected[1]);
    }
    constexpr long double Pi = 3.14159265358979323846264338327950288L;
    for (double angle = -1000; angle < 1000; angle += 0.37) {
        const long double radians = std::fmod(angle, 360.0) * (Pi / 180);
        const SinCos result = sin_cos_degrees(angle);
        CHECK(std::abs(static_cast<double>(result.sin - std::sin(radians))) < 2.3e-16);
        CHECK(std::abs(static_cast<double>(result.cos - std::cos(radians))) < 2.3e-16);
    }
    CHECK(sin_cos_degrees(1e300 * 1e300).cos == 1);
    CHECK(sin_cos_degrees(45).sin == Approx(std::sqrt(0.5)).epsilon(1e-16));
}

TEST_CASE("Sine and cosine keep the bits that were recorded") {
    const auto bits = [](double value) {
        std::uint64_t result;
        std::memcpy(&result, &value, sizeof result);
        return result;
    };
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int i = -720; i <= 720; ++i) {
        const SinCos value = sin_cos_degrees(i * 0.7310585786300049);
        for (const double part : {value.sin, value.cos})
            hash = (hash ^ bits(part)) * 0x100000001b3u;
    }
    CHECK(hash == 0xe8a2d83093b5b9f9u);
}

TEST_CASE("An inverse times its matrix is the identity, and of a singular matrix is the identity") {
    const Mat4 matrix =
        multiply(multiply(translation(1, 2, 3), rotation(33, 1, 2, 3)), scaling(2, 0.5, 4));
    const Mat4 product = multiply(matrix, inverse(matrix));
    for (std::size_t i = 0; i < 16; ++i)
        CHECK(product[i] == Approx(Identity4[i]).margin(1e-6));
    CHECK(inverse(scaling(1, 0, 1)) == Identity4);
    CHECK(normal_matrix(scaling(1, 1, 0)) == std::array<float, 9>{1, 0, 0, 0, 1, 0, 0, 0, 1});
}

TEST_CASE("Conversions to integers clamp, round to nearest, and take NaN for 0") {
    const double nan = std::nan("");
    CHECK(round_to_int(2.5) == 3);
    CHECK(round_to_int(-2.5) == -3);
    CHECK(round_to_int(1e20) == 2147483647);
    CHECK(round_to_int(-1e20) == -2147483647 - 1);
    CHECK(round_to_int(nan) == 0);
    CHECK(clamp_unit(nan) == 0);
    CHECK(clamp_unit(2.0f) == 1);
    CHECK(unorm(0.5, 8) == 128);
    CHECK(unorm(1, 24) == 0xffffff);
    CHECK(unorm(0.5 / 255 - 1e-9, 8) == 0);
    CHECK(unorm(0.5 / 255 + 1e-9, 8) == 1);
    CHECK(normalized_from_int(2147483647) == 1);
    CHECK(normalized_from_int(-2147483647 - 1) == -1);
}

} // namespace ffgpu::gl
