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

// A number plus it is rounded to the nearest integer, ties to even, which stands in two's
// complement in the lower 51 bits: all that is read of the sums below.
constexpr double Rounder = 0x1.8p52;

HWY_INLINE VD constant(double x) {
    return hn::Set(Doubles(), x);
}

HWY_INLINE VW bits_of(VD x) {
    return hn::BitCast(Words(), x);
}

// The constants of a primitive.
struct Frame {
    const PlaneBasis& basis;
    double factor, offset_x, offset_y, reach;

    explicit Frame(const AttributeFrame& frame)
        : basis(frame.basis)
        , factor(ExactQuotient::factor(frame.basis.per_divisor))
        , offset_x(frame.offset.x)
        , offset_y(frame.offset.y)
        , reach(static_cast<double>(frame.reach) / (1 << AttributePlane::GuardBits)) {}
};

// A gradient, and how far its estimate is from it.
struct Gradient {
    VD shifted; // by Rounder
    VD value;
    VD off;
};

HWY_INLINE Gradient gradient(VD numerator, double factor) {
    const VD by = constant(factor);
    const VD shifted = hn::MulAdd(numerator, by, constant(Rounder));
    const VD value = hn::Sub(shifted, constant(Rounder));
    return {shifted, value, hn::Abs(hn::MulSub(numerator, by, value))};
}

// As many values as a vector has and the layout carries, promoted; the others are 0.
HWY_INLINE VD load_floats(const float* from, unsigned first, unsigned carried) {
    const hn::Rebind<float, Doubles> d;
    if (first + hn::Lanes(d) <= MaxInterpolants) [[likely]]
        return hn::PromoteTo(Doubles(), hn::MaskedLoad(hn::FirstN(d, carried), d, from + first));
    std::array<float, 8> rest{};
    std::copy_n(from + first, carried, rest.begin());
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
    const unsigned carried =
        std::min(std::max(count, first) - first, static_cast<unsigned>(hn::Lanes(Doubles())));
    const VD factor =
        hn::IfThenElse(lanes_of(values.color_bits(), first), constant(255), constant(1));
    const auto is_k = lanes_of(std::uint64_t{1} << count, first);
    const auto at = [&](unsigned j) HWY_ATTR {
        const VD k = constant(values.k[j]);
        // 255 k is exact, so that there is one rounding.
        const VD value = hn::Mul(load_floats(values.of[j], first, carried), hn::Mul(factor, k));
        return hn::IfThenElse(is_k, k, value);
    };
    return {at(0), at(1), at(2)};
}

// Bits of `a` where the mask has them, else of `b`.
HWY_INLINE VW select(std::uint64_t mask, VW a, VW b) {
    const VW bits = hn::Set(Words(), mask);
    return hn::OrAnd(hn::AndNot(bits, b), bits, a);
}

// StoredPlane, of vectors: its 32 bytes as four words of 64 bits. `c` includes Half, `exponent`
// stands where fraction_and_scale has it; of the steps the lower 51 bits count.
HWY_INLINE void store(VW c, VW dx, VW dy, VW exponent, StoredPlane* to) {
    constexpr int Low = StoredPlane::LowBits, High = Low + StoredPlane::MiddleBits;
    constexpr std::uint64_t LowerWord = 0xffffffff, EvenHalves = 0x0000ffff0000ffff;
    constexpr std::uint64_t Parts =
        std::uint64_t{StoredPlane::MiddleMask} << 32 | StoredPlane::LowMask;
    const Words d;
    // Low bits where they stand, those above the guard bits in the upper word.
    const VW x = select(LowerWord, dx, hn::ShiftLeft<32 - Low>(dx));
    const VW y = select(LowerWord, dy, hn::ShiftLeft<32 - Low>(dy));
    const VW steps =
        hn::And(select(EvenHalves, x, hn::ShiftLeft<16>(y)), hn::Set(d, Parts << 16 | Parts));
    const VW high = select(EvenHalves, hn::ShiftRight<High>(dx), hn::ShiftRight<High - 16>(dy));
    const VW half = hn::Set(d, AttributePlane::Half);
    const VW right = hn::Add(dx, half), up = hn::Add(dy, half);
    hn::StoreInterleaved4(
        hn::Or(hn::ShiftLeft<32 - Low>(c), exponent),
        steps,
        select(LowerWord, high, hn::ShiftLeft<32 - Low>(right)),
        select(LowerWord, hn::ShiftRight<Low>(up), hn::ShiftLeft<32 - Low>(hn::Add(right, dy))),
        d,
        reinterpret_cast<std::uint64_t*>(to));
}

// c + Half, of vertex 0 shifted by Rounder and the way to the reference pixel.
HWY_INLINE VW reference_value(VD q0, const Gradient& x, const Gradient& y, const Frame& frame) {
    constexpr double HalfUp = 128 + 256 * AttributePlane::Half;
    const VD by_x = hn::MulAdd(x.value, constant(frame.offset_x), constant(Rounder + HalfUp));
    const VD way = hn::MulAdd(y.value, constant(frame.offset_y), by_x);
    const VI whole =
        hn::Sub(hn::BitCast(Integers(), way), hn::BitCast(Integers(), constant(Rounder)));
    return hn::Add(hn::ShiftLeft<AttributePlane::GuardBits>(bits_of(q0)),
                   hn::BitCast(Words(), hn::ShiftRight<8>(whole)));
}

// Lanes whose gradients are beyond doubt and whose exponent has not to rise.
HWY_INLINE hn::Mask<Doubles> sure(const Gradient& x, const Gradient& y, double reach) {
    const VD steps = hn::Add(hn::Abs(x.value), hn::Abs(y.value));
    // Two roundings are 2^-52 of a quotient, and little more.
    const VD doubt = hn::MulAdd(steps, constant(0x1.4p-52), hn::Max(x.off, y.off));
    const VD reached = hn::Mul(steps, constant(reach));
    constexpr double Room = 0x1p31 - 0x1p21 - (1 << ValueBits);
    return hn::And(hn::Lt(doubt, constant(0.5 - 0x1p-50)), hn::Lt(reached, constant(Room)));
}

// Attributes `first` and on; returns a bit for each that the specification has to set up.
HWY_INLINE std::uint64_t set_up_lanes(const AttributeValues& values,
                                      unsigned first,
                                      const Frame& frame,
                                      StoredPlane* planes) {
    constexpr auto Field = [](int exponent) { return static_cast<std::uint64_t>(exponent) << 52; };
    constexpr double Least = 1.0 / (std::uint64_t{1} << (1 - LeastExponent));
    constexpr int ToScale = 52 - (23 - StoredPlane::ScaleShift);
    const Words d;
    const auto [a0, a1, a2] = load_values(values, first);
    const VD largest =
        hn::Max(hn::Max(hn::Abs(a0), constant(Least)), hn::Max(hn::Abs(a1), hn::Abs(a2)));
    const VW exponent = hn::And(bits_of(largest), hn::Set(d, Field(0x7ff)));
    const VD scale =
        hn::BitCast(Doubles(), hn::Sub(hn::Set(d, Field(1023 + 1022 + ValueBits)), exponent));

    const VD q0 = hn::MulAdd(a0, scale, constant(Rounder));
    const VD e1 = hn::Sub(hn::MulAdd(a1, scale, constant(Rounder)), q0);
    const VD e2 = hn::Sub(hn::MulAdd(a2, scale, constant(Rounder)), q0);
    const auto numerator = [&](double by1, double by2) HWY_ATTR {
        return hn::MulAdd(e1, constant(by1), hn::Mul(e2, constant(by2)));
    };
    const PlaneBasis& basis = frame.basis;
    const Gradient x = gradient(numerator(basis.x1, basis.x2), frame.factor);
    const Gradient y = gradient(numerator(basis.y1, basis.y2), frame.factor);

    const auto base = static_cast<std::uint64_t>(1022 - 127 + values.base_exponent());
    store(reference_value(q0, x, y, frame),
          bits_of(x.shifted),
          bits_of(y.shifted),
          hn::Sub(hn::ShiftRight<ToScale>(exponent), hn::Set(d, base << (52 - ToScale))),
          planes + first);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Doubles(), hn::Not(sure(x, y, frame.reach)), bits);
    return bits[0];
}

std::uint64_t
SetUpPlanes(const AttributeValues& values, const AttributeFrame& frame, StoredPlane* planes) {
    const Frame constants(frame);
    const unsigned count = values.count();
    std::uint64_t left = 0;
    for (unsigned i = 0; i < count; i += static_cast<unsigned>(hn::Lanes(Doubles())))
        left |= set_up_lanes(values, i, constants, planes) << i;
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
