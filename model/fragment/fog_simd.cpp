#include "model/arith/exp2.h"
#include "model/base/simd_targets.h"
#include "model/fragment/fog.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fragment/fog_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "model/fragment/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

using DFloat = hn::Rebind<float, DHalf16>;
using VFloat = hn::Vec<DFloat>;
using DSigned32 = hn::Rebind<std::int32_t, DHalf16>;
using VSigned32 = hn::Vec<DSigned32>;

HWY_INLINE VFloat set_float(float value) {
    return hn::Set(DFloat(), value);
}

// NaN and what is below 0 to 0.
HWY_INLINE VFloat at_least_zero(VFloat x) {
    return hn::IfThenElseZero(hn::Gt(x, hn::Zero(DFloat())), x);
}

// NaN and what is above to the limit.
HWY_INLINE VFloat at_most(VFloat x, float limit) {
    return hn::IfThenElse(hn::Lt(x, set_float(limit)), x, set_float(limit));
}

HWY_INLINE VSigned32 round_positive(VFloat x) {
    return hn::ConvertTo(DSigned32(), hn::Add(x, set_float(0.5f)));
}

// exp2_negative_unorm8() of model/arith/exp2.h.
HWY_INLINE VSigned32 exp2_negative_lanes(VSigned32 x) {
    const D32 d;
    const DSigned32 ds;
    const V32 fixed = hn::BitCast(d, x);
    const V32 fraction = hn::And(fixed, hn::Set(d, 0xffffu));
    const VSigned32 chord = hn::BitCast(ds, hn::ShiftRight<Exp2ChordBits>(fraction));
    const V32 entry = hn::GatherIndex(d, Exp2Table.data(), chord);
    const V32 low = hn::And(fixed, hn::Set(d, (1u << Exp2ChordBits) - 1));
    const V32 slope = hn::And(entry, hn::Set(d, (1u << Exp2SlopeBits) - 1));
    const V32 half = hn::Set(d, 1u << (Exp2ChordBits - 1));
    const V32 drop = hn::ShiftRight<Exp2ChordBits>(hn::Add(hn::Mul(slope, low), half));
    const V32 mantissa = hn::Sub(hn::ShiftRight<Exp2SlopeBits>(entry), drop);

    const V32 shift = hn::Add(hn::ShiftRight<16>(fixed), hn::Set(d, Exp2MantissaBits));
    const V32 one = hn::Set(d, 1u);
    const V32 rounding = hn::Shl(one, hn::Sub(shift, one));
    const V32 scaled = hn::Mul(mantissa, hn::Set(d, Unorm8One));
    return hn::BitCast(ds, hn::Shr(hn::Add(scaled, rounding), shift));
}

template <FogMode Mode>
HWY_INLINE VSigned32 factor_lanes(const FogCurve& curve, VFloat coordinate) {
    if constexpr (Mode == FogMode::Linear) {
        const VFloat f = hn::Mul(hn::Sub(set_float(curve.end), coordinate), set_float(curve.scale));
        return round_positive(hn::Mul(hn::Min(at_least_zero(f), set_float(1)), set_float(255)));
    } else {
        VFloat x = hn::Mul(coordinate, set_float(curve.scale));
        if constexpr (Mode == FogMode::Exp2) x = hn::Mul(hn::Mul(x, x), set_float(Log2E));
        x = at_least_zero(at_most(x, FogExponentLimit));
        return exp2_negative_lanes(round_positive(hn::Mul(x, set_float(65536))));
    }
}

HWY_INLINE void fade(std::uint16_t* plane, V16 factor, std::uint8_t fog_color) {
    const D16 d;
    const V16 kept = hn::Mul(factor, hn::Load(d, plane));
    const V16 fog = hn::Mul(complement(factor), set16(fog_color));
    hn::Store(divide_by_255(hn::Add(kept, fog)), d, plane);
}

template <FogMode Mode>
void fog_lanes(const FogCurve& curve, FragmentBatch& batch) {
    const DFloat df;
    const DHalf16 dh;
    ColorPlanes& color = batch.color;
    for (unsigned i = 0; i < batch.lanes(); i += Lanes16) {
        const float* coordinate = batch.fog_coordinate.data() + i;
        const VSigned32 lower = factor_lanes<Mode>(curve, hn::Load(df, coordinate));
        const VSigned32 upper = factor_lanes<Mode>(curve, hn::Load(df, coordinate + Lanes32));
        const V16 factor = hn::Combine(D16(), hn::DemoteTo(dh, upper), hn::DemoteTo(dh, lower));
        fade(color.r.data() + i, factor, curve.color[0]);
        fade(color.g.data() + i, factor, curve.color[1]);
        fade(color.b.data() + i, factor, curve.color[2]);
    }
}

void apply_fog_lanes(const FogCurve& curve, FragmentBatch& batch) {
    switch (curve.mode) {
    case FogMode::Off:
        return;
    case FogMode::Linear:
        return fog_lanes<FogMode::Linear>(curve, batch);
    case FogMode::Exp:
        return fog_lanes<FogMode::Exp>(curve, batch);
    case FogMode::Exp2:
        return fog_lanes<FogMode::Exp2>(curve, batch);
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(apply_fog_lanes);

void apply_fog(const FogCurve& curve, FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(apply_fog_lanes)(curve, batch);
}

} // namespace ffgpu
#endif
