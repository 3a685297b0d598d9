// Sine and cosine of an angle in degrees, the same bits on every machine: only + - * and an exact
// remainder (docs/arithmetic/driver.md). Within two units in the last place of binary64.

#pragma once

namespace ffgpu::gl {

struct SinCos {
    double sin, cos;
};

// Multiples of 90 degrees are exact. An angle that is not finite counts as 0.
SinCos sin_cos_degrees(double angle);

} // namespace ffgpu::gl
