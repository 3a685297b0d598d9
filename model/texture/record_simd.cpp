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

// An access is four words on a little endian host.
static_assert(sizeof(TexelAccess) == 16 && offsetof(TexelAccess, level) == 2 &&
              offsetof(TexelAccess, linear) == 3 && offsetof(TexelAccess, x0) == 4 &&
              offsetof(TexelAccess, y0) == 8 && offsetof(TexelAccess, layer0) == 12);

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

HWY_INLINE VI head_word(const TextureUnit& unit, unsigned lane, const Pass& pass) {
    const VI axes = constant((1 << unit.dimensions) - 1);
    const VI linear = hn::IfThenElseZero(pass.linear, axes);
    const VI lanes = hn::Iota(DI(), static_cast<std::int32_t>(lane));
    return hn::Or(lanes, hn::Or(hn::ShiftLeft<16>(pass.level), hn::ShiftLeft<24>(linear)));
}

// The words of a vector of accesses.
struct AccessWords {
    VI head, x, y, layers;
};

HWY_INLINE AccessWords words_of(const TextureUnit& unit,
                                const FilterInputs& in,
                                unsigned lane,
                                const Pass& pass) {
    const VI none = hn::Zero(DI());
    AccessWords words{head_word(unit, lane, pass), none, none, none};
    words.x = index_word(unit, 0, hn::Load(DF(), in.coordinates->s.data() + lane), pass);
    if (unit.dimensions > 1)
        words.y = index_word(unit, 1, hn::Load(DF(), in.coordinates->t.data() + lane), pass);
    if (unit.dimensions > 2)
        words.layers = index_word(unit, 2, hn::Load(DF(), in.coordinates->r.data() + lane), pass);
    if (unit.kind == TextureKind::Cube) {
        const VI face = hn::Load(DI(), in.face + lane);
        words.layers = hn::Or(face, hn::ShiftLeft<16>(face));
    }
    return words;
}

HWY_INLINE VI first_of(VI word) {
    return hn::And(word, constant(0xffff));
}

// Lanes whose second texel along an axis is not the first one's neighbour, or the first one itself
// where `steps` is 0; and those that meet the border.
HWY_INLINE MI irregular_axis(VI word, VI steps) {
    const VI first = first_of(word);
    const VI second = first_of(hn::ShiftRight<16>(word));
    return hn::Or(hn::Ne(hn::Sub(second, first), steps),
                  hn::Or(hn::Eq(first, constant(TexelAccess::BorderTexel)),
                         hn::Eq(second, constant(TexelAccess::BorderTexel))));
}

// Between slices no access counts as regular.
HWY_INLINE MI irregular(const TextureUnit& unit, const AccessWords& words, const Pass& pass) {
    if (unit.dimensions > 2) return hn::Eq(words.x, words.x);
    const VI steps = hn::IfThenElseZero(pass.linear, constant(1));
    const MI along_x = irregular_axis(words.x, steps);
    return hn::Or(along_x, irregular_axis(words.y, unit.dimensions > 1 ? steps : hn::Zero(DI())));
}

HWY_INLINE void store_place(const AccessWords& words, unsigned lane, AccessBatch::Level& out) {
    const VI place = hn::Or(first_of(words.x), hn::ShiftLeft<16>(words.y));
    hn::Store(hn::BitCast(DU(), place), DU(), out.places.data() + lane);
}

HWY_INLINE void store_whole(const AccessWords& words, unsigned lane, AccessBatch::Level& out) {
    hn::StoreInterleaved4(words.head,
                          words.x,
                          words.y,
                          words.layers,
                          DI(),
                          reinterpret_cast<std::int32_t*>(out.accesses.data() + lane));
}

void record_accesses(const TextureUnit& unit, const FilterInputs& in, AccessBatch& out) {
    const auto step = static_cast<unsigned>(hn::Lanes(DI()));
    const SamplingBatch& sampling = *in.sampling;
    const bool two_levels = sampling.any_weight();
    const VI byte = constant(0xff);
    out.irregular = {};
    for (unsigned lane = 0; lane < 4 * in.quad_count; lane += step) {
        const VI choice = hn::BitCast(DI(), hn::Load(DU(), sampling.choice.data() + lane));
        Pass pass{hn::And(choice, byte),
                  hn::TestBit(choice, constant(SamplingBatch::LinearBit)),
                  sampling.any_linear(),
                  sampling.any_nearest()};
        const AccessWords words = words_of(unit, in, lane, pass);
        AccessWords next = words;
        MI odd = irregular(unit, words, pass);
        store_place(words, lane, out.level);
        if (two_levels) {
            pass.level = hn::And(hn::ShiftRight<8>(choice), byte);
            next = words_of(unit, in, lane, pass);
            const MI counts = hn::Ne(hn::And(choice, constant(0xff << 16)), hn::Zero(DI()));
            odd = hn::Or(odd, hn::And(counts, irregular(unit, next, pass)));
            store_place(next, lane, out.next_level);
        }
        const bool whole = !hn::AllFalse(DI(), odd);
        for (unsigned quad = lane / 4; quad < (lane + step) / 4; ++quad)
            out.whole[quad] = whole;
        if (!whole) continue;
        out.irregular.words[lane / 64] |= bits_from_mask(DI(), odd) << lane % 64;
        store_whole(words, lane, out.level);
        if (two_levels) store_whole(next, lane, out.next_level);
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

void record_batch(const TextureUnit& unit, const FilterInputs& inputs, AccessBatch& out) {
    HWY_DYNAMIC_DISPATCH(record_accesses)(unit, inputs, out);
}

} // namespace ffgpu
#endif
