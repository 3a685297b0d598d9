// An attribute's plane from its values at three vertices, in binary64 lanes: the integers of
// attribute_setup.cpp, all of which are exact there. A quotient is rounded from its estimate; lanes
// whose estimate lies too near to a tie, or whose exponent has to rise, are told, for the
// specification to set up. What a lane is, an attribute of a triangle or a triangle, is the
// caller's. Included once for each instruction set.

#if defined(FFGPU_MODEL_RASTER_ATTRIBUTE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_RASTER_ATTRIBUTE_LANES_INL_H
#undef FFGPU_MODEL_RASTER_ATTRIBUTE_LANES_INL_H
#else
#define FFGPU_MODEL_RASTER_ATTRIBUTE_LANES_INL_H
#endif

#include "model/raster/attribute_setup.h"
#include "model/raster/exact_quotient.h"

#include <array>
#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Integers = hn::RebindToSigned<Doubles>;
using Words = hn::RebindToUnsigned<Doubles>;
using VD = hn::Vec<Doubles>;
using VI = hn::Vec<Integers>;
using VW = hn::Vec<Words>;
using MaskD = hn::Mask<Doubles>;

// A number plus it is rounded to the nearest integer, ties to even, which stands in two's
// complement in the lower 51 bits: all that is read of the sums below.
constexpr double Rounder = 0x1.8p52;

HWY_INLINE VD constant(double x) {
    return hn::Set(Doubles(), x);
}

HWY_INLINE VW bits_of(VD x) {
    return hn::BitCast(Words(), x);
}

// AttributeFrame, of the lanes' triangles.
struct FrameLanes {
    VD x1, x2, y1, y2; // PlaneBasis
    VD factor;         // ExactQuotient::factor()
    VD offset_x, offset_y;
    double reach; // in units of a step without its guard bits

    static double reach_of(int pixels) {
        return static_cast<double>(pixels) / (1 << AttributePlane::GuardBits);
    }
};

// A gradient, and how far its estimate is from it.
struct Gradient {
    VD shifted; // by Rounder
    VD value;
    VD off;
};

HWY_INLINE Gradient gradient(VD numerator, VD factor) {
    const VD shifted = hn::MulAdd(numerator, factor, constant(Rounder));
    const VD value = hn::Sub(shifted, constant(Rounder));
    return {shifted, value, hn::Abs(hn::MulSub(numerator, factor, value))};
}

// Bits of `a` where the mask has them, else of `b`.
HWY_INLINE VW select(std::uint64_t mask, VW a, VW b) {
    const VW bits = hn::Set(Words(), mask);
    return hn::OrAnd(hn::AndNot(bits, b), bits, a);
}

// Planes before they are stored. `c` includes Half, `scale` stands where fraction_and_scale has it;
// of the steps the lower 51 bits count.
struct PlaneLanes {
    VW c, dx, dy, scale;
    MaskD sure; // Elsewhere the specification has to set the plane up.
};

// StoredPlane, of vectors: its 32 bytes as four words of 64 bits.
HWY_INLINE void store(const PlaneLanes& plane, StoredPlane* to) {
    constexpr int Low = StoredPlane::LowBits, High = Low + StoredPlane::MiddleBits;
    constexpr std::uint64_t LowerWord = 0xffffffff, EvenHalves = 0x0000ffff0000ffff;
    constexpr std::uint64_t Parts =
        std::uint64_t{StoredPlane::MiddleMask} << 32 | StoredPlane::LowMask;
    const Words d;
    const VW dx = plane.dx, dy = plane.dy;
    // Low bits where they stand, those above the guard bits in the upper word.
    const VW x = select(LowerWord, dx, hn::ShiftLeft<32 - Low>(dx));
    const VW y = select(LowerWord, dy, hn::ShiftLeft<32 - Low>(dy));
    const VW steps =
        hn::And(select(EvenHalves, x, hn::ShiftLeft<16>(y)), hn::Set(d, Parts << 16 | Parts));
    const VW high = select(EvenHalves, hn::ShiftRight<High>(dx), hn::ShiftRight<High - 16>(dy));
    const VW half = hn::Set(d, AttributePlane::Half);
    const VW right = hn::Add(dx, half), up = hn::Add(dy, half);
    hn::StoreInterleaved4(
        hn::Or(hn::ShiftLeft<32 - Low>(plane.c), plane.scale),
        steps,
        select(LowerWord, high, hn::ShiftLeft<32 - Low>(right)),
        select(LowerWord, hn::ShiftRight<Low>(up), hn::ShiftLeft<32 - Low>(hn::Add(right, dy))),
        d,
        reinterpret_cast<std::uint64_t*>(to));
}

// c + Half, of vertex 0 shifted by Rounder and the way to the reference pixel.
HWY_INLINE VW reference_value(VD q0, const Gradient& x, const Gradient& y, const FrameLanes& f) {
    constexpr double HalfUp = 128 + 256 * AttributePlane::Half;
    const VD by_x = hn::MulAdd(x.value, f.offset_x, constant(Rounder + HalfUp));
    const VD way = hn::MulAdd(y.value, f.offset_y, by_x);
    const VI whole =
        hn::Sub(hn::BitCast(Integers(), way), hn::BitCast(Integers(), constant(Rounder)));
    return hn::Add(hn::ShiftLeft<AttributePlane::GuardBits>(bits_of(q0)),
                   hn::BitCast(Words(), hn::ShiftRight<8>(whole)));
}

// Lanes whose gradients are beyond doubt and whose exponent has not to rise.
HWY_INLINE MaskD sure(const Gradient& x, const Gradient& y, double reach) {
    const VD steps = hn::Add(hn::Abs(x.value), hn::Abs(y.value));
    // Two roundings are 2^-52 of a quotient, and little more.
    const VD doubt = hn::MulAdd(steps, constant(0x1.4p-52), hn::Max(x.off, y.off));
    const VD reached = hn::Mul(steps, constant(reach));
    constexpr double Room = 0x1p31 - 0x1p21 - (1 << ValueBits);
    return hn::And(hn::Lt(doubt, constant(0.5 - 0x1p-50)), hn::Lt(reached, constant(Room)));
}

// The part of `scale` that takes an exponent off those of all planes.
constexpr std::uint64_t scale_base(int base_exponent) {
    return static_cast<std::uint64_t>(1022 - 127 + base_exponent) << (23 - StoredPlane::ScaleShift);
}

// The plane with these values at the vertices.
HWY_INLINE PlaneLanes plane_lanes(const std::array<VD, 3>& a, VW base, const FrameLanes& frame) {
    constexpr auto Field = [](int exponent) { return static_cast<std::uint64_t>(exponent) << 52; };
    constexpr double Least = 1.0 / (std::uint64_t{1} << (1 - LeastExponent));
    constexpr int ToScale = 52 - (23 - StoredPlane::ScaleShift);
    const Words d;
    const VD largest =
        hn::Max(hn::Max(hn::Abs(a[0]), constant(Least)), hn::Max(hn::Abs(a[1]), hn::Abs(a[2])));
    const VW exponent = hn::And(bits_of(largest), hn::Set(d, Field(0x7ff)));
    const VD scale =
        hn::BitCast(Doubles(), hn::Sub(hn::Set(d, Field(1023 + 1022 + ValueBits)), exponent));

    const VD q0 = hn::MulAdd(a[0], scale, constant(Rounder));
    const VD e1 = hn::Sub(hn::MulAdd(a[1], scale, constant(Rounder)), q0);
    const VD e2 = hn::Sub(hn::MulAdd(a[2], scale, constant(Rounder)), q0);
    const auto numerator = [&](VD by1, VD by2)
                               HWY_ATTR { return hn::MulAdd(e1, by1, hn::Mul(e2, by2)); };
    const Gradient x = gradient(numerator(frame.x1, frame.x2), frame.factor);
    const Gradient y = gradient(numerator(frame.y1, frame.y2), frame.factor);
    return {reference_value(q0, x, y, frame),
            bits_of(x.shifted),
            bits_of(y.shifted),
            hn::Sub(hn::ShiftRight<ToScale>(exponent), base),
            sure(x, y, frame.reach)};
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
