// The filter over a batch, in passes: one for each level and kind of filter that some fragment
// needs, then the choice and interpolation between their results. Most batches are a single pass,
// at a single level, whose constants then stay in registers.

#include "model/texture/sampling_batch.h"
#include "model/texture/simd_targets.h"

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/texture/filter_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#if HWY_TARGET != HWY_SCALAR
#include "model/texture/texel_places-inl.h"
#endif
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
// One lane cannot hold two channels; sample() asks and takes the reference instead.
bool has_vectors() {
    return false;
}
void filter_texels(const TextureUnit&, const FilterInputs&, ColorPlanes&) {}
#else
bool has_vectors() {
    return true;
}

// A pass's result: two channels in a word, as Color16 has them.
struct PackedColors {
    alignas(64) std::array<std::uint16_t, 2 * BatchFragments> rb, ga;

    HWY_INLINE Color16 load(unsigned lane) const {
        return {hn::Load(D16(), rb.data() + 2 * lane), hn::Load(D16(), ga.data() + 2 * lane)};
    }
    HWY_INLINE void store(const Color16& color, unsigned lane) {
        hn::Store(color.rb, D16(), rb.data() + 2 * lane);
        hn::Store(color.ga, D16(), ga.data() + 2 * lane);
    }
};

// Which of a choice's two levels a pass reads, and whether all lanes have the same one.
struct LevelSource {
    bool next;
    bool same;

    HWY_INLINE VI level(VU choice) const {
        const VU at = next ? hn::ShiftRight<8>(choice) : choice;
        return hn::BitCast(DI(), hn::And(at, hn::Set(DU(), 0xff)));
    }
    // Vectors in which no lane weighs the next level are left out.
    HWY_INLINE bool skips(VU choice) const {
        if (!next) return false;
        const VU weight = hn::And(choice, hn::Set(DU(), 0xff0000));
        return hn::AllTrue(DU(), hn::Eq(weight, hn::Zero(DU())));
    }
};

constexpr unsigned Step = hn::MaxLanes(DI());

// Calls visit(lane, level) for each vector that the pass has to do with.
template <class K, class Visit>
HWY_INLINE void for_each_vector(const TextureUnit& unit,
                                const FilterInputs& in,
                                const LevelSource& source,
                                Visit&& visit) {
    const std::uint32_t* choices = in.sampling->choice.data();
    LevelVectors level;
    set_level<K>(unit, source.level(hn::Load(DU(), choices)), level);
    for (unsigned lane = 0; lane < 4 * grouped_quads(in.quad_count); lane += Step) {
        const VU choice = hn::Load(DU(), choices + lane);
        if (source.skips(choice)) continue;
        if (!source.same) set_level<K>(unit, source.level(choice), level);
        visit(lane, level);
    }
}

template <class K, bool Linear>
HWY_NOINLINE void place_pass(const TextureUnit& unit,
                             const FilterInputs& in,
                             const LevelSource& source,
                             TexelPlaces& places) {
    for_each_vector<K>(unit, in, source, [&](unsigned lane, const LevelVectors& level) HWY_ATTR {
        place_texels<K, Linear>(unit, in, level, lane, places);
    });
}

template <class K, bool Linear>
HWY_NOINLINE void load_pass(const TextureUnit& unit,
                            const FilterInputs& in,
                            const LevelSource& source,
                            const TexelPlaces& places,
                            PackedColors& out) {
    for (unsigned lane = 0; lane < 4 * grouped_quads(in.quad_count); lane += Step) {
        const VU choice = hn::Load(DU(), in.sampling->choice.data() + lane);
        if (source.skips(choice)) continue;
        if (places.regular[lane]) {
            out.store(filter_places<K, Linear>(unit, places, lane), lane);
            continue;
        }
        LevelVectors level;
        set_level<K>(unit, source.level(choice), level);
        out.store(filter_level<K, Linear>(unit, in, level, lane), lane);
    }
}

template <class K, bool Linear>
HWY_NOINLINE void filter_pass(const TextureUnit& unit,
                              const FilterInputs& in,
                              const LevelSource& source,
                              PackedColors& out) {
    if constexpr (HasPlaces<K>) {
        TexelPlaces places;
        place_pass<K, Linear>(unit, in, source, places);
        load_pass<K, Linear>(unit, in, source, places, out);
    } else {
        for_each_vector<K>(
            unit, in, source, [&](unsigned lane, const LevelVectors& level) HWY_ATTR {
                out.store(filter_level<K, Linear>(unit, in, level, lane), lane);
            });
    }
}

HWY_INLINE Color16 select(MI mask, const Color16& yes, const Color16& no) {
    const auto wide = hn::MaskFromVec(hn::BitCast(D16(), hn::VecFromMask(DI(), mask)));
    return {hn::IfThenElse(wide, yes.rb, no.rb), hn::IfThenElse(wide, yes.ga, no.ga)};
}

// One level with the filter of each lane. Two passes only where a batch has both filters.
template <class K>
void filter_lanes(const TextureUnit& unit,
                  const FilterInputs& in,
                  const LevelSource& source,
                  PackedColors& out) {
    const SamplingBatch& sampling = *in.sampling;
    if (!sampling.any_nearest()) return filter_pass<K, true>(unit, in, source, out);
    filter_pass<K, false>(unit, in, source, out);
    if (!sampling.any_linear()) return;

    PackedColors linear;
    filter_pass<K, true>(unit, in, source, linear);
    for (unsigned lane = 0; lane < 4 * grouped_quads(in.quad_count); lane += Step) {
        const VU choice = hn::Load(DU(), sampling.choice.data() + lane);
        const VI bit = constant(SamplingBatch::LinearBit);
        const MI is_linear = hn::TestBit(hn::BitCast(DI(), choice), bit);
        out.store(select(is_linear, linear.load(lane), out.load(lane)), lane);
    }
}

// Between a lane's two levels. What skipped vectors left in `coarse` has weight 0.
void lerp_levels(const FilterInputs& in, const PackedColors& coarse, PackedColors& fine) {
    for (unsigned lane = 0; lane < 4 * grouped_quads(in.quad_count); lane += Step) {
        const VU choice = hn::Load(DU(), in.sampling->choice.data() + lane);
        const VU weight = hn::And(hn::ShiftRight<9>(choice), hn::Set(DU(), 0xff << 7));
        const VU both = hn::Or(weight, hn::ShiftLeft<16>(weight));
        const VI weights = hn::BitCast(DI(), both);
        fine.store(lerp8w(fine.load(lane), coarse.load(lane), weights), lane);
    }
}

void unpack(const PackedColors& colors, unsigned lanes, ColorPlanes& out) {
    const D16 d;
    for (unsigned lane = 0; lane < lanes; lane += 2 * Step) {
        const Color16 lower = colors.load(lane), upper = colors.load(lane + Step);
        hn::Store(hn::ConcatEven(d, upper.rb, lower.rb), d, out.r.data() + lane);
        hn::Store(hn::ConcatEven(d, upper.ga, lower.ga), d, out.g.data() + lane);
        hn::Store(hn::ConcatOdd(d, upper.rb, lower.rb), d, out.b.data() + lane);
        hn::Store(hn::ConcatOdd(d, upper.ga, lower.ga), d, out.a.data() + lane);
    }
}

template <class K>
void filter_all(const TextureUnit& unit, const FilterInputs& in, ColorPlanes& out) {
    const SamplingBatch& sampling = *in.sampling;
    PackedColors colors;
    filter_lanes<K>(unit, in, {false, sampling.one_level()}, colors);
    if (sampling.any_weight()) {
        PackedColors coarse{};
        filter_lanes<K>(unit, in, {true, sampling.one_next_level()}, coarse);
        lerp_levels(in, coarse, colors);
    }
    unpack(colors, 4 * grouped_quads(in.quad_count), out);
}

template <class Texels>
void filter_kind(const TextureUnit& unit, const FilterInputs& in, ColorPlanes& out) {
    if (unit.srgb) return filter_all<Kernel<SrgbTexels<Texels>, false, true>>(unit, in, out);
    const bool plain = unit.kind == TextureKind::TwoD || unit.kind == TextureKind::Rectangle;
    const bool border = unit.border != 0 || unit.border_color;
    if (!plain) return filter_all<Kernel<Texels, false, true>>(unit, in, out);
    if (border) return filter_all<Kernel<Texels, true, true>>(unit, in, out);
    filter_all<Kernel<Texels, true, false>>(unit, in, out);
}

void filter_texels(const TextureUnit& unit, const FilterInputs& in, ColorPlanes& out) {
    const FormatInfo& info = format_info(unit.format);
    if (info.is_depth) return filter_all<Kernel<DepthTexels, false, true>>(unit, in, out);
    if (info.block_width == 8)
        return unit.srgb ? filter_all<Kernel<SrgbTexels<Fxt1Texels>, false, true>>(unit, in, out)
                         : filter_all<Kernel<Fxt1Texels, false, true>>(unit, in, out);
    if (info.block_width > 1) return filter_kind<BlockTexels>(unit, in, out);
    if (unit.format == Format::Rgba8) return filter_kind<WordTexels>(unit, in, out);
    if (info.block_bytes == 4) return filter_kind<OpaqueWordTexels>(unit, in, out);
    filter_kind<SmallTexels>(unit, in, out);
}

#endif // HWY_SCALAR

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {
HWY_EXPORT(has_vectors);
HWY_EXPORT(filter_texels);
} // namespace

bool can_filter_batches() {
    return HWY_DYNAMIC_DISPATCH(has_vectors)();
}

void filter_batch(const TextureUnit& unit, const FilterInputs& inputs, ColorPlanes& out) {
    HWY_DYNAMIC_DISPATCH(filter_texels)(unit, inputs, out);
}

} // namespace ffgpu
#endif
