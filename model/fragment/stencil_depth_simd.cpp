#include "model/base/simd_targets.h"
#include "model/fragment/stencil_depth.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fragment/stencil_depth_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "model/fragment/compare_lanes-inl.h"
#include "model/fragment/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

// Depths and stencil values are below 2^24: they compare the same as signed numbers.
using DSigned32 = hn::Rebind<std::int32_t, DHalf16>;

HWY_INLINE M32 compare_words(Compare function, V32 value, V32 reference) {
    const DSigned32 d;
    return hn::RebindMask(
        D32(), compare_lanes(d, function, hn::BitCast(d, value), hn::BitCast(d, reference)));
}

HWY_INLINE V32 set32(std::uint32_t value) {
    return hn::Set(D32(), value);
}

// --- Depth alone --------------------------------------------------------------------------------

// The live fragments that pass.
template <Compare Function>
FragmentMask test_depth(const FragmentBatch& batch, LaneWords& pixels) {
    const D32 d;
    return collect_mask<Lanes32>(batch.live, batch.lanes(), [&](unsigned i) HWY_ATTR {
        std::uint32_t* pixel = pixels.data() + i;
        const V32 stored = hn::Load(d, pixel);
        const V32 depth = hn::Load(d, batch.depth.data() + i);
        hn::Store(hn::Or(hn::ShiftLeft<8>(depth), hn::And(stored, set32(255))), d, pixel);
        return bits_from_mask(d, compare_words(Function, depth, hn::ShiftRight<8>(stored)));
    });
}

FragmentMask test_depth_only(Compare function, const FragmentBatch& batch, LaneWords& pixels) {
    switch (function) {
    case Compare::Never:
        return {};
    case Compare::Less:
        return test_depth<Compare::Less>(batch, pixels);
    case Compare::Equal:
        return test_depth<Compare::Equal>(batch, pixels);
    case Compare::Lequal:
        return test_depth<Compare::Lequal>(batch, pixels);
    case Compare::Greater:
        return test_depth<Compare::Greater>(batch, pixels);
    case Compare::Notequal:
        return test_depth<Compare::Notequal>(batch, pixels);
    case Compare::Gequal:
        return test_depth<Compare::Gequal>(batch, pixels);
    case Compare::Always:
        return test_depth<Compare::Always>(batch, pixels);
    }
    return {};
}

// --- Everything
// -----------------------------------------------------------------------------------

HWY_INLINE V32 stencil_value(StencilOp op, V32 stored, V32 reference) {
    const V32 one = set32(1), all = set32(255), none = hn::Zero(D32());
    switch (op) {
    case StencilOp::Keep:
        return stored;
    case StencilOp::Zero:
        return none;
    case StencilOp::Replace:
        return reference;
    case StencilOp::Increment:
        return hn::Min(hn::Add(stored, one), all);
    case StencilOp::Decrement:
        return hn::Sub(hn::Max(stored, one), one);
    case StencilOp::Invert:
        return hn::Xor(stored, all);
    case StencilOp::IncrementWrap:
        return hn::And(hn::Add(stored, one), all);
    case StencilOp::DecrementWrap:
        return hn::And(hn::Sub(stored, one), all);
    }
    return stored;
}

struct Passes {
    M32 bounds, stencil, depth;
};

HWY_INLINE Passes test_lanes(const StencilDepthState& state,
                             const StencilFace& face,
                             V32 depth,
                             V32 stored) {
    const M32 all = hn::Eq(stored, stored);
    const V32 stored_depth = hn::ShiftRight<8>(stored);
    Passes passes{all, all, all};
    if (state.depth.bounds_enable) {
        const V32 low = set32(state.depth.bounds_min), high = set32(state.depth.bounds_max);
        passes.bounds = hn::And(compare_words(Compare::Gequal, stored_depth, low),
                                compare_words(Compare::Lequal, stored_depth, high));
    }
    if (state.stencil) {
        const V32 reference = set32(unsigned{face.reference} & face.compare_mask);
        passes.stencil =
            compare_words(face.compare, reference, hn::And(stored, set32(face.compare_mask)));
    }
    if (state.depth.test_enable)
        passes.depth = compare_words(state.depth.compare, depth, stored_depth);
    return passes;
}

// What a lane within the bounds stores.
HWY_INLINE V32 new_pixel(const StencilDepthState& state,
                         const StencilFace& face,
                         const Passes& passes,
                         V32 depth,
                         V32 stored) {
    V32 pixel = stored;
    if (state.depth.write_enable) {
        const V32 written = hn::Or(hn::ShiftLeft<8>(depth), hn::And(stored, set32(255)));
        pixel = hn::IfThenElse(hn::And(passes.stencil, passes.depth), written, stored);
    }
    if (!state.stencil) return pixel;
    const V32 value = hn::And(stored, set32(255)), reference = set32(face.reference);
    const V32 fail = stencil_value(face.fail, value, reference);
    const V32 depth_fail = stencil_value(face.depth_fail, value, reference);
    const V32 depth_pass = stencil_value(face.depth_pass, value, reference);
    const V32 result =
        hn::IfThenElse(passes.stencil, hn::IfThenElse(passes.depth, depth_pass, depth_fail), fail);
    const V32 mask = set32(face.write_mask);
    return hn::Or(hn::AndNot(mask, pixel), hn::And(mask, result));
}

// The lanes of one face; the words of other lanes stay.
void test_face(const StencilDepthState& state,
               const StencilFace& face,
               const FragmentBatch& batch,
               const FragmentMask& active,
               StencilDepthFates& fates,
               LaneWords& pixels) {
    const D32 d;
    for (unsigned i = 0; i < batch.lanes(); i += Lanes32) {
        const std::uint64_t active_bits = mask_bits(active, i, Lanes32);
        if (active_bits == 0) continue;
        std::uint32_t* at = pixels.data() + i;
        const V32 stored = hn::Load(d, at);
        const V32 depth = hn::Load(d, batch.depth.data() + i);
        const Passes passes = test_lanes(state, face, depth, stored);
        const M32 tested = hn::And(mask_from_bits(d, active_bits), passes.bounds);
        const V32 pixel = new_pixel(state, face, passes, depth, stored);
        hn::Store(hn::IfThenElse(tested, pixel, stored), d, at);

        const M32 passed = hn::And(tested, passes.stencil);
        fates.after_stencil.words[i / 64] |= bits_from_mask(d, passed) << (i % 64);
        fates.after_depth.words[i / 64] |= bits_from_mask(d, hn::And(passed, passes.depth))
                                           << (i % 64);
    }
}

// The live fragments of front facing quads.
FragmentMask front_lanes(const FragmentBatch& batch) {
    FragmentMask mask;
    for (unsigned q = 0; q < batch.quad_count; ++q)
        if ((batch.front_facing[q / 64] >> (q % 64) & 1) != 0)
            mask.words[q / 16] |= std::uint64_t{0xf} << (4 * (q % 16));
    return both(mask, batch.live);
}

FragmentMask difference(const FragmentMask& all, const FragmentMask& part) {
    FragmentMask rest;
    for (unsigned i = 0; i < rest.words.size(); ++i)
        rest.words[i] = all.words[i] & ~part.words[i];
    return rest;
}

StencilDepthFates test_stencil_depth_lanes(const StencilDepthState& state,
                                           const FragmentBatch& batch,
                                           LaneWords& pixels) {
    StencilDepthFates fates;
    if (!state.stencil && !state.depth.bounds_enable) {
        fates.after_stencil = batch.live;
        fates.after_depth = test_depth_only(state.depth.compare, batch, pixels);
        return fates;
    }
    const FragmentMask front = front_lanes(batch), back = difference(batch.live, front);
    if (front.any()) test_face(state, state.front, batch, front, fates, pixels);
    if (back.any()) test_face(state, state.back, batch, back, fates, pixels);
    return fates;
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(test_stencil_depth_lanes);

StencilDepthFates
test_stencil_depth(const StencilDepthState& state, const FragmentBatch& batch, LaneWords& pixels) {
    return HWY_DYNAMIC_DISPATCH(test_stencil_depth_lanes)(state, batch, pixels);
}

} // namespace ffgpu
#endif
