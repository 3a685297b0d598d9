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
#include "model/arith/lanes/mask_bits-inl.h"
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
    const WrapRule& rule = Linear ? unit.linear_rules[axis] : unit.nearest_rules[axis];
    const auto both = [](VI first, VI second) { return hn::Or(first, hn::ShiftLeft<16>(second)); };
    if (unit.border == 0 && !rule.border) return both(texels.first, texels.second); // all inside
    return both(marked(unit, texels.first, at.size), marked(unit, texels.second, at.size));
}

// ... and for the filter of each lane.
HWY_INLINE VI index_word(const TextureUnit& unit, unsigned axis, VF folded, const Pass& pass) {
    const AxisLevel at = axis_level(unit, axis, pass.level);
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

// A vector of fragments' coordinates, folded: the same at all levels.
struct Folded {
    VF s, t, r; // those of the texture's dimensions
};

HWY_INLINE Folded folded_at(const TextureUnit& unit, const FilterInputs& in, unsigned lane) {
    const auto fold = [&](unsigned axis, const float* plane) {
        if (axis >= unit.dimensions) return hn::Zero(DF());
        return fold_coordinate(
            unit.linear_rules[axis].fold, hn::Load(DF(), plane + lane), unit.extent[axis]);
    };
    return {fold(0, in.coordinates->s.data()),
            fold(1, in.coordinates->t.data()),
            fold(2, in.coordinates->r.data())};
}

HWY_INLINE void record(const TextureUnit& unit,
                       const FilterInputs& in,
                       unsigned lane,
                       const Folded& folded,
                       const Pass& pass,
                       AccessPlane& out) {
    using Words = AccessPlane::Words;
    const auto store = [&](Words which, VI words) {
        hn::StoreU(hn::BitCast(DU(), words), DU(), out.words(which) + lane);
    };
    store(Words::X, index_word(unit, 0, folded.s, pass));
    store(Words::Y, unit.dimensions < 2 ? hn::Zero(DI()) : index_word(unit, 1, folded.t, pass));
    if (unit.dimensions == 3) store(Words::Layers, index_word(unit, 2, folded.r, pass));
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
        const Folded folded = folded_at(unit, in, lane);
        record(unit, in, lane, folded, pass, *out.level);
        if (!out.next_level) continue;
        pass.level = hn::And(hn::ShiftRight<8>(choice), byte);
        record(unit, in, lane, folded, pass, *out.next_level);
    }
}

void weighted_bits(const SamplingBatch& sampling, unsigned quad_count, FragmentMask& mask) {
    const DU d;
    const auto step = static_cast<unsigned>(hn::Lanes(d));
    const auto weight = hn::Set(d, SamplingBatch::WeightBits);
    for (unsigned lane = 0; lane < 4 * quad_count; lane += step) {
        const auto choice = hn::Load(d, sampling.choice.data() + lane);
        mask.words[lane / 64] |= bits_from_mask(d, hn::Ne(hn::And(choice, weight), hn::Zero(d)))
                                 << lane % 64;
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {
HWY_EXPORT(record_accesses);
HWY_EXPORT(weighted_bits);
} // namespace

void record_batch(const TextureUnit& unit, const FilterInputs& inputs, const AccessPlanes& out) {
    HWY_DYNAMIC_DISPATCH(record_accesses)(unit, inputs, out);
}

FragmentMask weighted_lanes(const SamplingBatch& sampling, unsigned quad_count) {
    FragmentMask mask;
    HWY_DYNAMIC_DISPATCH(weighted_bits)(sampling, quad_count, mask);
    return mask;
}

} // namespace ffgpu
#endif
