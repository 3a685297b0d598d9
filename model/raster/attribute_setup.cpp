// The specification of block floating point set-up, an attribute at a time.

#include "model/raster/attribute_setup.h"

#include "model/raster/exact_quotient.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ffgpu {
namespace {

using Integers = std::array<std::int64_t, 3>;

// The least e with |value| < 2^e; of binary64 numbers that are not subnormal.
int exponent_above(double value) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(value) >> 52 & 0x7ff) - 1022;
}

double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// To nearest, ties to even; |value| < 2^51.
std::int64_t round_to_even(double value) {
    constexpr double Shift = 0x1.8p52;
    return static_cast<std::int64_t>((value + Shift) - Shift);
}

Integers quantised(const std::array<double, 3>& values, int exponent) {
    const double scale = power_of_two(ValueBits - exponent);
    return {round_to_even(values[0] * scale),
            round_to_even(values[1] * scale),
            round_to_even(values[2] * scale)};
}

struct Numerators {
    std::int64_t x, y;
};

Numerators numerators(const Integers& q, const PlaneBasis& basis) {
    const std::int64_t e1 = q[1] - q[0], e2 = q[2] - q[0];
    const auto whole = [](double x) { return static_cast<std::int64_t>(x); };
    return {e1 * whole(basis.x1) + e2 * whole(basis.x2),
            e1 * whole(basis.y1) + e2 * whole(basis.y2)};
}

// How far the exponent has to rise for all lanes to fit.
int shift_for_lanes(const Integers& q, const AttributeFrame& frame) {
    constexpr double Limit = 0x1p31 - 0x1p20;
    const Numerators n = numerators(q, frame.basis);
    const double steps =
        (std::fabs(static_cast<double>(n.x)) + std::fabs(static_cast<double>(n.y))) *
        frame.basis.per_divisor;
    const std::int64_t largest = std::max({std::abs(q[0]), std::abs(q[1]), std::abs(q[2])});
    int shift = 0;
    for (double reached = static_cast<double>(largest) + frame.reach * steps; reached >= Limit;
         reached *= 0.5)
        ++shift;
    return shift;
}

} // namespace

BlockPlane set_up_block_plane(const std::array<double, 3>& values, const AttributeFrame& frame) {
    const double largest =
        std::max({std::fabs(values[0]), std::fabs(values[1]), std::fabs(values[2])});
    BlockPlane plane;
    plane.exponent = exponent_above(std::max(largest, power_of_two(LeastExponent - 1)));
    Integers q = quantised(values, plane.exponent);
    if (const int shift = shift_for_lanes(q, frame)) {
        plane.exponent += shift;
        q = quantised(values, plane.exponent);
    }
    const ExactQuotient quotient(frame.basis.divisor, frame.basis.per_divisor);
    const Numerators n = numerators(q, frame.basis);
    plane.dx = quotient(n.x);
    plane.dy = quotient(n.y);
    const std::int64_t to_reference = plane.dx * frame.offset.x + plane.dy * frame.offset.y;
    plane.c = q[0] * (std::int64_t{1} << AttributePlane::GuardBits) + ((to_reference + 128) >> 8);
    return plane;
}

std::array<double, 3> AttributeValues::at(unsigned i) const {
    if (i == layout.count) return k;
    const double factor = (color_bits() >> i & 1) != 0 ? 255 : 1;
    std::array<double, 3> values;
    for (unsigned j = 0; j < 3; ++j)
        values[j] = static_cast<double>(of[j][i]) * factor * k[j];
    return values;
}

StoredPlane set_up_attribute(const std::array<double, 3>& values,
                             const AttributeFrame& frame,
                             int base_exponent) {
    const BlockPlane plane = set_up_block_plane(values, frame);
    const double scale = power_of_two(plane.exponent - base_exponent);
    return StoredPlane({plane.c, plane.dx, plane.dy, static_cast<float>(scale)});
}

int set_up_attributes_scalar(const AttributeValues& values,
                             const AttributeFrame& frame,
                             StoredPlane* planes) {
    const int base_exponent =
        values.perspective ? set_up_block_plane(values.k, frame).exponent : ValueBits;
    for (unsigned i = 0; i < values.count(); ++i)
        planes[i] = set_up_attribute(values.at(i), frame, base_exponent);
    return base_exponent;
}

} // namespace ffgpu
