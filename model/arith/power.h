// power(): x^y for lighting, x any number, y >= 0: exp2(y log2(x)).
//
// x <= 0 and NaN count as 0; 0^0 is 1. Results below 2^-126 are 0, above 2^127 they stop there. A y
// that is NaN gives 0.

#pragma once

#include "model/arith/exp2_log2.h"

namespace ffgpu {

namespace log_exp {
constexpr float LeastPower = -126.0f;
constexpr float GreatestPower = 127.0f;
constexpr float LeastBase = 0x1p-126f;
constexpr float GreatestBase = 0x1p+126f;
} // namespace log_exp

constexpr float power(float x, float y) {
    using namespace log_exp;
    float base = x > LeastBase ? x : LeastBase;
    base = base < GreatestBase ? base : GreatestBase;
    const float exponent = y * log2_binary32(base);
    float clamped = exponent > LeastPower ? exponent : LeastPower;
    clamped = clamped < GreatestPower ? clamped : GreatestPower;
    const float result = exp2_binary32(clamped);
    if (!(exponent >= LeastPower)) return 0.0f;
    return x > 0.0f || y == 0.0f ? result : 0.0f;
}

} // namespace ffgpu
