// The reciprocal: IEEE binary32 division, 1 / x rounded to nearest even. Error: half a unit in the
// last place, and none for powers of two, which a table with Newton steps would not give.
//
// Why not the table: a divider of 24 bits is a small pipelined unit at one fragment a clock, every
// SIMD host divides as fast as it would gather and iterate, and the rule fits one line.

#pragma once

namespace ffgpu {

// x is not 0.
constexpr float reciprocal(float x) {
    return 1.0f / x;
}

} // namespace ffgpu
