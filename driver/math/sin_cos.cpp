#include "driver/math/sin_cos.h"

#include <cmath>

namespace ffgpu::gl {
namespace {

constexpr double Pi = 3.14159265358979323846;

// Taylor series, for |x| <= pi / 4. The first term left out is below 2^-58 of the result.
double sin_small(double x) {
    const double xx = x * x;
    double sum = 1.0 / 355687428096000.0; // 17!
    sum = sum * xx - 1.0 / 1307674368000.0;
    sum = sum * xx + 1.0 / 6227020800.0;
    sum = sum * xx - 1.0 / 39916800.0;
    sum = sum * xx + 1.0 / 362880.0;
    sum = sum * xx - 1.0 / 5040.0;
    sum = sum * xx + 1.0 / 120.0;
    sum = sum * xx - 1.0 / 6.0;
    return x + x * (xx * sum);
}

double cos_small(double x) {
    const double xx = x * x;
    double sum = 1.0 / 20922789888000.0; // 16!
    sum = sum * xx - 1.0 / 87178291200.0;
    sum = sum * xx + 1.0 / 479001600.0;
    sum = sum * xx - 1.0 / 3628800.0;
    sum = sum * xx + 1.0 / 40320.0;
    sum = sum * xx - 1.0 / 720.0;
    sum = sum * xx + 1.0 / 24.0;
    sum = sum * xx - 1.0 / 2.0;
    return 1.0 + xx * sum;
}

} // namespace

SinCos sin_cos_degrees(double angle) {
    if (!std::isfinite(angle)) return {0, 1};
    const double turn = std::fmod(angle, 360.0);         // exact
    const double quarters = std::floor(turn / 90 + 0.5); // -4 .. 4
    const double x = (turn - 90 * quarters) * (Pi / 180);
    const double sin = sin_small(x);
    const double cos = cos_small(x);
    switch (static_cast<int>(quarters) & 3) {
    case 0:
        return {sin, cos};
    case 1:
        return {cos, -sin};
    case 2:
        return {-sin, -cos};
    default:
        return {-cos, sin};
    }
}

} // namespace ffgpu::gl
