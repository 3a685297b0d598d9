// The fast form of attribute_setup.cpp: the same integers, held in binary64 lanes, where all of
// them are exact. A quotient is rounded from its estimate; attributes whose estimate lies too near
// to a tie, or whose exponent has to rise, are left to the specification.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/attribute_setup_simd.cpp"

#include "model/raster/attribute_setup.h"
#include "model/raster/exact_quotient.h"

#include <algorithm>
#include <array>
#include <bit>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, 8>;
using Integers = hn::RebindToSigned<Doubles>;
using Words = hn::RebindToUnsigned<Doubles>;
using VD = hn::Vec<Doubles>;
using VI = hn::Vec<Integers>;
using VW = hn::Vec<Words>;

// Adding and subtracting it rounds to the nearest integer, ties to even; below 2^51.
constexpr double Rounder = 0x1.8p52;

HWY_INLINE VD constant(double x) {
    return hn::Set(Doubles(), x);
}

// A number rounded to an integer, as binary64.
struct Rounded {
    VD shifted; // by Rounder

    explicit HWY_INLINE Rounded(VD x)
        : shifted(hn::Add(x, constant(Rounder))) {}
    HWY_INLINE VD value() const { return hn::Sub(shifted, constant(Rounder)); }
    HWY_INLINE VW bits() const {
        return hn::Sub(hn::BitCast(Words(), shifted), hn::BitCast(Words(), constant(Rounder)));
    }
};

HWY_INLINE VD rounded(VD x) {
    return Rounded(x).value();
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
    VD estimate;
    Rounded rounded;
    VD margin;
};

HWY_INLINE Gradient gradient(VD numerator, VD factor) {
    const VD estimate = hn::Mul(numerator, factor);
    const Rounded rounded(estimate);
    // Two roundings are 2^-52 of it, and little more.
    const VD error = hn::Mul(hn::Abs(estimate), constant(0x1.4p-52));
    const VD off = hn::Abs(hn::Sub(estimate, rounded.value()));
    return {estimate, rounded, hn::Sub(hn::Sub(constant(0.5), off), error)};
}

HWY_INLINE VD largest_of(VD a, VD b, VD c) {
    return hn::Max(hn::Max(hn::Abs(a), hn::Abs(b)), hn::Abs(c));
}

// As many values as a vector has and the layout carries, promoted; the others are 0.
HWY_INLINE VD load_floats(const float* from, unsigned first, unsigned count) {
    const hn::Rebind<float, Doubles> d;
    const auto carried = hn::FirstN(d, count > first ? count - first : 0);
    if (first + hn::Lanes(d) <= MaxInterpolants)
        return hn::PromoteTo(Doubles(), hn::MaskedLoad(carried, d, from + first));
    std::array<float, 8> rest{};
    std::copy(from + first, from + std::max(count, first), rest.begin());
    return hn::PromoteTo(Doubles(), hn::LoadU(d, rest.data()));
}

// Lanes whose bit from `first` on is set.
HWY_INLINE hn::Mask<Doubles> lanes_of(std::uint64_t bits, unsigned first) {
    const auto bytes = std::bit_cast<std::array<std::uint8_t, 8>>(bits >> first);
    return hn::LoadMaskBits(Doubles(), bytes.data());
}

// The attributes from `first` on at the three vertices: AttributeValues::at().
HWY_INLINE std::array<VD, 3> load_values(const AttributeValues& values, unsigned first) {
    const unsigned count = values.layout.count;
    const VD factor =
        hn::IfThenElse(lanes_of(values.color_bits(), first), constant(255), constant(1));
    const auto is_k = lanes_of(std::uint64_t{1} << count, first);
    const auto at = [&](unsigned j) HWY_ATTR {
        const VD value = hn::Mul(load_floats(values.of[j], first, count), factor);
        return hn::Mul(hn::IfThenElse(is_k, constant(1), value), constant(values.k[j]));
    };
    return {at(0), at(1), at(2)};
}

// StoredPlane, of vectors: its 32 bytes as four words of 64 bits. `scale` is the bits of a
// binary32.
HWY_INLINE void store(VW c, VW dx, VW dy, VW scale, StoredPlane* to) {
    constexpr int Low = StoredPlane::LowBits, High = Low + StoredPlane::MiddleBits;
    const Words d;
    const VW half = hn::Set(d, AttributePlane::Half);
    const VW low_mask = hn::Set(d, StoredPlane::LowMask);
    const VW upper_word = hn::Set(d, ~std::uint64_t{0} << 32);
    const VW middle_mask = hn::Set(d, std::uint64_t{StoredPlane::MiddleMask} << 32);
    const VW top_mask = hn::Set(d, 0xffff);
    // Without guard bits, in the upper word.
    const auto above = [&](VW x)
                           HWY_ATTR { return hn::And(hn::ShiftLeft<32 - Low>(x), upper_word); };
    const auto low_and_middle = [&](VW x) HWY_ATTR {
        return hn::OrAnd(hn::And(x, low_mask), hn::ShiftLeft<32 - Low>(x), middle_mask);
    };
    const auto high = [&](VW x) HWY_ATTR { return hn::And(hn::ShiftRight<High>(x), top_mask); };
    const auto pair = [&](VW x, VW y) HWY_ATTR { return hn::Or(x, hn::ShiftLeft<16>(y)); };

    const VW whole = hn::Add(c, half), right = hn::Add(dx, half), up = hn::Add(dy, half);
    const VW up_only = hn::ShiftRight<32>(above(up));
    hn::StoreInterleaved4(hn::OrAnd(hn::Or(scale, above(whole)), whole, low_mask),
                          pair(low_and_middle(dx), low_and_middle(dy)),
                          hn::Or(pair(high(dx), high(dy)), above(right)),
                          hn::Or(up_only, above(hn::Add(right, dy))),
                          d,
                          reinterpret_cast<std::uint64_t*>(to));
}

// Attributes `first` and on; returns a bit for each that the specification has to set up.
HWY_INLINE std::uint64_t set_up_lanes(const AttributeValues& values,
                                      unsigned first,
                                      const Frame& frame,
                                      StoredPlane* planes) {
    const Doubles d;
    const Integers di;
    const auto [a0, a1, a2] = load_values(values, first);
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
    const VD way = hn::Add(hn::Mul(x.rounded.value(), frame.offset_x),
                           hn::Mul(y.rounded.value(), frame.offset_y));
    const VD to_reference = rounded(hn::Add(hn::Mul(way, constant(0x1p-8)), constant(0x1p-10)));
    const VD c = hn::Add(hn::Mul(q0, constant(1 << AttributePlane::GuardBits)), to_reference);
    const VI exponent = hn::Sub(field, hn::Set(di, 1022 - 127 + values.base_exponent()));
    store(Rounded(c).bits(),
          x.rounded.bits(),
          y.rounded.bits(),
          hn::BitCast(Words(), hn::ShiftLeft<23>(exponent)),
          planes + first);

    const VD steps = hn::Add(hn::Abs(x.estimate), hn::Abs(y.estimate));
    const VD reached = hn::Add(largest_of(q0, q1, q2), hn::Mul(steps, frame.reach));
    const auto sure = hn::And(hn::Gt(hn::Min(x.margin, y.margin), hn::Zero(d)),
                              hn::Lt(reached, constant(0x1p31 - 0x1p21)));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Not(sure), bits);
    return bits[0];
}

std::uint64_t
SetUpPlanes(const AttributeValues& values, const AttributeFrame& frame, StoredPlane* planes) {
    const Frame spread_frame = spread(frame);
    const unsigned count = values.count();
    std::uint64_t left = 0;
    for (unsigned i = 0; i < count; i += static_cast<unsigned>(hn::Lanes(Doubles())))
        left |= set_up_lanes(values, i, spread_frame, planes) << i;
    return left & ((std::uint64_t{1} << count) - 1);
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(SetUpPlanes);

int set_up_attributes(const AttributeValues& values,
                      const AttributeFrame& frame,
                      StoredPlane* planes) {
    const std::uint64_t left = HWY_DYNAMIC_DISPATCH(SetUpPlanes)(values, frame, planes);
    if (left == 0) return values.base_exponent();
    if (values.perspective && left >> values.layout.count != 0)
        return set_up_attributes_scalar(values, frame, planes);
    for (std::uint64_t rest = left; rest != 0; rest &= rest - 1) {
        const auto i = static_cast<unsigned>(std::countr_zero(rest));
        planes[i] = set_up_attribute(values.at(i), frame, values.base_exponent());
    }
    return values.base_exponent();
}

} // namespace ffgpu
#endif
