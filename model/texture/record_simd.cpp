// The work stream's side of filter_simd.cpp: wraps the same coordinates again, but reads nothing.
// Apart from the filter, so that sampling without a work stream pays nothing for it.

#include "model/texture/sampling_batch.h"
#include "model/texture/simd_targets.h"

#include <cstddef>

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/texture/record_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "model/texture/axis-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

// The level and filter of a vector of fragments, and which filters the batch has at all.
struct Pass {
    VI level;
    MI linear;
    bool any_linear, any_nearest;
};

HWY_INLINE VI marked(const TextureUnit& unit, VI index, VI size) {
    const StoredIndex stored = stored_index(unit, index, size);
    return hn::IfThenElse(stored.outside, constant(TexelAccess::BorderTexel), stored.index);
}

// Both indices of one axis in a word, for one kind of filter ...
template <bool Linear>
HWY_INLINE VI filter_word(const TextureUnit& unit, unsigned axis, VF folded, const AxisLevel& at) {
    const AxisTexelVectors texels = axis_texels<Linear>(unit, axis, folded, at);
    const VI upper = hn::ShiftLeft<16>(marked(unit, texels.second, at.size));
    return hn::Or(marked(unit, texels.first, at.size), upper);
}

// ... and for the filter of each lane.
HWY_INLINE VI index_word(const TextureUnit& unit, unsigned axis, VF coordinate, const Pass& pass) {
    const AxisLevel at = axis_level(unit, axis, pass.level);
    const VF folded = fold_coordinate(unit.linear_rules[axis].fold, coordinate, unit.extent[axis]);
    if (!pass.any_nearest) return filter_word<true>(unit, axis, folded, at);
    const VI nearest = filter_word<false>(unit, axis, folded, at);
    if (!pass.any_linear) return nearest;
    return hn::IfThenElse(pass.linear, filter_word<true>(unit, axis, folded, at), nearest);
}

// AccessPlane::heads
HWY_INLINE void record_heads(const TextureUnit& unit, const Pass& pass, std::uint16_t* to) {
    const VI axes = constant((1 << unit.dimensions) - 1);
    const VI linear = hn::IfThenElseZero(pass.linear, axes);
    const hn::Rebind<std::uint16_t, DI> d;
    hn::StoreU(hn::DemoteTo(d, hn::Or(pass.level, hn::ShiftLeft<8>(linear))), d, to);
}

HWY_INLINE void record(const TextureUnit& unit,
                       const FilterInputs& in,
                       unsigned lane,
                       const Pass& pass,
                       AccessPlane& out) {
    using Words = AccessPlane::Words;
    constexpr Words Axes[]{Words::X, Words::Y, Words::Layers};
    const float* planes[3] = {
        in.coordinates->s.data(), in.coordinates->t.data(), in.coordinates->r.data()};
    const auto store = [&](Words which, VI words) {
        hn::StoreU(hn::BitCast(DU(), words), DU(), out.words(which) + lane);
    };
    for (unsigned axis = 0; axis < unit.dimensions; ++axis)
        store(Axes[axis], index_word(unit, axis, hn::Load(DF(), planes[axis] + lane), pass));
    if (unit.dimensions < 2) store(Words::Y, hn::Zero(DI()));
    if (unit.kind == TextureKind::Cube) {
        const VI face = hn::Load(DI(), in.face + lane);
        store(Words::Layers, hn::Or(face, hn::ShiftLeft<16>(face)));
    }
    record_heads(unit, pass, out.heads() + lane);
}

void record_accesses(const TextureUnit& unit, const FilterInputs& in, const AccessPlanes& out) {
    const auto step = static_cast<unsigned>(hn::Lanes(DI()));
    const SamplingBatch& sampling = *in.sampling;
    const VI byte = constant(0xff);
    for (unsigned lane = 0; lane < 4 * in.quad_count; lane += step) {
        const VI choice = hn::BitCast(DI(), hn::Load(DU(), sampling.choice.data() + lane));
        Pass pass{hn::And(choice, byte),
                  hn::TestBit(choice, constant(SamplingBatch::LinearBit)),
                  sampling.any_linear(),
                  sampling.any_nearest()};
        record(unit, in, lane, pass, *out.level);
        if (!out.next_level) continue;
        pass.level = hn::And(hn::ShiftRight<8>(choice), byte);
        record(unit, in, lane, pass, *out.next_level);
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {
HWY_EXPORT(record_accesses);
} // namespace

void record_batch(const TextureUnit& unit, const FilterInputs& inputs, const AccessPlanes& out) {
    HWY_DYNAMIC_DISPATCH(record_accesses)(unit, inputs, out);
}

} // namespace ffgpu
#endif
