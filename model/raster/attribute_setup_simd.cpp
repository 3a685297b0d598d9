// The fast form of attribute_setup.cpp: the same integers, held in binary64 lanes, where all of
// them are exact. A quotient is rounded from its estimate; attributes whose estimate lies too near
// to a tie, or whose exponent has to rise, are left to the specification.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/attribute_setup_simd.cpp"

#include "model/raster/attribute_setup.h"
#include "model/raster/exact_quotient.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 4>;
using Integers = hn::RebindToSigned<Doubles>;
using VD = hn::Vec<Doubles>;
using VI = hn::Vec<Integers>;

// Adding and subtracting it rounds to the nearest integer, ties to even; below 2^51.
constexpr double Rounder = 0x1.8p52;

HWY_INLINE VD constant(double x) {
    return hn::Set(Doubles(), x);
}

HWY_INLINE VD rounded(VD x) {
    return hn::Sub(hn::Add(x, constant(Rounder)), constant(Rounder));
}

HWY_INLINE VI to_integers(VD whole) {
    const VI bits = hn::BitCast(Integers(), hn::Add(whole, constant(Rounder)));
    return hn::Sub(bits, hn::BitCast(Integers(), constant(Rounder)));
}

// The constants of a primitive, spread.
struct Frame {
    VD x1, x2, y1, y2, factor, offset_x, offset_y, reach;
};

HWY_INLINE Frame spread(const AttributeFrame& frame) {
    const PlaneBasis& basis = frame.basis;
    return {constant(basis.x1),
            constant(basis.x2),
            constant(basis.y1),
            constant(basis.y2),
            constant(ExactQuotient(basis.divisor).factor()),
            constant(frame.offset.x),
            constant(frame.offset.y),
            constant(static_cast<double>(frame.reach) / (1 << AttributePlane::GuardBits))};
}

// A gradient, and how far it is from where its rounding could be in doubt: not positive if it is.
struct Gradient {
    VD estimate, value, margin;
};

HWY_INLINE Gradient gradient(VD numerator, VD factor) {
    const VD estimate = hn::Mul(numerator, factor);
    const VD value = rounded(estimate);
    const VD error = hn::Mul(hn::Abs(estimate), constant(0x1p-51));
    const VD margin = hn::Sub(hn::Sub(constant(0.5), hn::Abs(hn::Sub(estimate, value))), error);
    return {estimate, value, margin};
}

HWY_INLINE VD largest_of(VD a, VD b, VD c) {
    return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c));
}

HWY_INLINE void store(VI value, std::int64_t* to) {
    hn::Store(value, Integers(), to);
}

// Attributes `first` and on; returns a bit for each that the specification has to set up.
HWY_INLINE std::uint64_t
set_up_lanes(const VertexValues& values, unsigned first, const Frame& frame, BlockPlanes& planes) {
    const Doubles d;
    const Integers di;
    const VD a0 = hn::Load(d, values.of[0].data() + first);
    const VD a1 = hn::Load(d, values.of[1].data() + first);
    const VD a2 = hn::Load(d, values.of[2].data() + first);
    constexpr double Least = 1.0 / (std::uint64_t{1} << (1 - LeastExponent));
    const VD largest = hn::Max(largest_of(a0, a1, a2), constant(Least));
    const VI field = hn::ShiftRight<52>(hn::BitCast(di, largest));
    const VI scale_field = hn::Sub(hn::Set(di, 1023 + 1022 + ValueBits), field);
    const VD scale = hn::BitCast(d, hn::ShiftLeft<52>(scale_field));

    const VD q0 = rounded(hn::Mul(a0, scale));
    const VD q1 = rounded(hn::Mul(a1, scale));
    const VD q2 = rounded(hn::Mul(a2, scale));
    const VD e1 = hn::Sub(q1, q0), e2 = hn::Sub(q2, q0);
    const Gradient x =
        gradient(hn::Add(hn::Mul(e1, frame.x1), hn::Mul(e2, frame.x2)), frame.factor);
    const Gradient y =
        gradient(hn::Add(hn::Mul(e1, frame.y1), hn::Mul(e2, frame.y2)), frame.factor);

    // Halves go up: the sum has no more than 8 fraction bits.
    const VD way = hn::Add(hn::Mul(x.value, frame.offset_x), hn::Mul(y.value, frame.offset_y));
    const VD to_reference = rounded(hn::Add(hn::Mul(way, constant(0x1p-8)), constant(0x1p-10)));
    const VD c = hn::Add(hn::Mul(q0, constant(1 << AttributePlane::GuardBits)), to_reference);
    store(to_integers(c), planes.c.data() + first);
    store(to_integers(x.value), planes.dx.data() + first);
    store(to_integers(y.value), planes.dy.data() + first);
    store(hn::Sub(field, hn::Set(di, 1022)), planes.exponent.data() + first);

    const VD steps = hn::Add(hn::Abs(x.estimate), hn::Abs(y.estimate));
    const VD reached = hn::Add(largest_of(q0, q1, q2), hn::Mul(steps, frame.reach));
    const auto sure = hn::And(hn::Gt(hn::Min(x.margin, y.margin), hn::Zero(d)),
                              hn::Lt(reached, constant(0x1p31 - 0x1p21)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Not(sure), bits);
    return bits[0];
}

std::uint64_t SetUpPlanes(const VertexValues& values,
                          unsigned count,
                          const AttributeFrame& frame,
                          BlockPlanes& planes) {
    const Frame spread_frame = spread(frame);
    std::uint64_t left = 0;
    for (unsigned i = 0; i < count; i += static_cast<unsigned>(hn::Lanes(Doubles())))
        left |= set_up_lanes(values, i, spread_frame, planes) << i;
    return left;
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(SetUpPlanes);

void set_up_block_planes(const VertexValues& values,
                         unsigned count,
                         const AttributeFrame& frame,
                         BlockPlanes& planes) {
    const std::uint64_t left = HWY_DYNAMIC_DISPATCH(SetUpPlanes)(values, count, frame, planes);
    for (unsigned i = 0; i < count; ++i) {
        if (((left >> i) & 1) == 0) continue;
        const BlockPlane plane =
            set_up_block_plane({values.of[0][i], values.of[1][i], values.of[2][i]}, frame);
        planes.c[i] = plane.c;
        planes.dx[i] = plane.dx;
        planes.dy[i] = plane.dy;
        planes.exponent[i] = plane.exponent;
    }
}

} // namespace ffgpu
#endif
