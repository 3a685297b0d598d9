// Vector form of wrap.h: texels of one axis, each lane at a level of its own.
// Included once for each instruction set.

#if defined(FFGPU_MODEL_TEXTURE_AXIS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_TEXTURE_AXIS_INL_H
#undef FFGPU_MODEL_TEXTURE_AXIS_INL_H
#else
#define FFGPU_MODEL_TEXTURE_AXIS_INL_H
#endif

#include "model/texture/texture_unit.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using MI = hn::Mask<DI>;

HWY_INLINE VI constant(std::int32_t value) {
    return hn::Set(DI(), value);
}

HWY_INLINE MI no_lanes() {
    return hn::Ne(constant(0), constant(0));
}

// Constants of one axis at the lanes' levels.
struct AxisLevel {
    VI size;
    VF scale; // raw texel coordinate for each unit of the coordinate
};

HWY_INLINE AxisLevel axis_level(const TextureUnit& unit, unsigned axis, VI level) {
    const VI shifted = hn::Shr(hn::Set(DI(), unit.size[axis]), level);
    const VI size = hn::Max(shifted, constant(1));
    const VF scale = hn::ConvertTo(DF(), hn::ShiftLeft<8>(size));
    return {size, unit.normalized ? scale : hn::Set(DF(), 256.0f)};
}

HWY_INLINE VF fraction(VF x) {
    const auto has_fraction = hn::Lt(hn::Abs(x), hn::Set(DF(), 0x1p23f));
    return hn::IfThenElseZero(has_fraction, hn::Sub(x, hn::Floor(x)));
}

HWY_INLINE VF fold_coordinate(Fold fold, VF s, float extent) {
    const DF d;
    if (fold == Fold::Repeat) return fraction(s);
    if (fold == Fold::Mirror) {
        const VF half = fraction(hn::Mul(s, hn::Set(d, 0.5f)));
        const VF twice = hn::Add(half, half);
        return hn::Min(twice, hn::Sub(hn::Set(d, 2.0f), twice));
    }
    if (fold == Fold::MirrorClamp) s = hn::Abs(s);
    return hn::Min(hn::Max(s, hn::Set(d, -1.0f)), hn::Set(d, extent + 1));
}

// Of less than 2^22 in magnitude: the sum leaves no fraction bits. Folded coordinates of the
// largest images are below.
HWY_INLINE VI round_to_int(VF x) {
    const VF shift = hn::Set(DF(), 0x1.8p23f);
    return hn::Sub(hn::BitCast(DI(), hn::Add(x, shift)), hn::BitCast(DI(), shift));
}

HWY_INLINE VI texel_coordinate(VF folded, const AxisLevel& level, const WrapRule& rule) {
    const VI raw = round_to_int(hn::Mul(folded, level.scale));
    if (rule.wraps) return raw; // From 0 to the size as it is.
    const VI high = hn::Add(hn::ShiftLeft<8>(level.size), constant(rule.above));
    return hn::Min(hn::Max(raw, constant(rule.low)), high);
}

// Indices of wrap.h's AxisTexels; the weight comes times 128, in both halves of its lane.
struct AxisTexelVectors {
    VI first, second;
    VI weight;
};

// resolve_index() for an index that is not negative.
HWY_INLINE VI resolve_above(VI index, VI size, const WrapRule& rule) {
    if (rule.wraps) return hn::IfThenZeroElse(hn::Eq(index, size), index);
    return hn::Min(index, hn::Add(size, constant(rule.border ? 0 : -1)));
}

HWY_INLINE AxisTexelVectors nearest_texel(VI coordinate, VI size, const WrapRule& rule) {
    const VI index = resolve_above(hn::ShiftRight<8>(coordinate), size, rule);
    return {index, index, hn::Zero(DI())};
}

HWY_INLINE AxisTexelVectors linear_texels(VI coordinate, VI size, const WrapRule& rule) {
    const VI from_centre = hn::Sub(coordinate, constant(128));
    const VI index = hn::ShiftRight<8>(from_centre);
    const VI weight = hn::And(hn::ShiftLeft<7>(from_centre), constant(0xff << 7));
    const VI both_weights = hn::Or(weight, hn::ShiftLeft<16>(weight));
    // -1 stays where it means a border texel; a wrapping axis turns it into size - 1.
    const VI below = hn::And(hn::ShiftRight<31>(index), size);
    const VI first = rule.wraps ? hn::Add(index, below) : index;
    const VI second = resolve_above(hn::Add(index, constant(1)), size, rule);
    return {first, second, both_weights};
}

template <bool Linear>
HWY_INLINE AxisTexelVectors
axis_texels(const TextureUnit& unit, unsigned axis, VF folded, const AxisLevel& level) {
    const WrapRule& rule = Linear ? unit.linear_rules[axis] : unit.nearest_rules[axis];
    const VI coordinate = texel_coordinate(folded, level, rule);
    if constexpr (Linear) return linear_texels(coordinate, level.size, rule);
    return nearest_texel(coordinate, level.size, rule);
}

// An index as the stored image counts it, safe to address with, and whether the border colour
// stands for it.
struct StoredIndex {
    VI index;
    MI outside;
};

HWY_INLINE StoredIndex stored_index(const TextureUnit& unit, VI index, VI size) {
    const VI stored = hn::Add(index, constant(unit.border));
    const VI last = hn::Add(size, constant(2 * unit.border - 1));
    const VI inside = hn::Min(hn::Max(stored, hn::Zero(DI())), last);
    return {inside, hn::Ne(inside, stored)};
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
