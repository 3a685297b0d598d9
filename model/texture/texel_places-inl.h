// The quick way to the texels of plain images: where all lanes of a batch read is found first, and
// stored; then their texels are loaded one by one, two neighbours together, each put into its lane
// as it comes. Gathers take almost twice as long where they are microcode; and the loads of one
// vector need not wait for its own arithmetic.
// Included once for each instruction set.

#if defined(FFGPU_MODEL_TEXTURE_TEXEL_PLACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_TEXTURE_TEXEL_PLACES_INL_H
#undef FFGPU_MODEL_TEXTURE_TEXEL_PLACES_INL_H
#else
#define FFGPU_MODEL_TEXTURE_TEXEL_PLACES_INL_H
#endif

#include "model/texture/level_filter-inl.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

// Images that this goes for.
template <class K>
constexpr bool HasPlaces = K::Plain&& requires {
    typename K::Texels::Pair;
};

// What a batch reads of one level. A nearest filter reads `first` alone.
struct TexelPlaces {
    using Lanes = std::array<std::int32_t, BatchFragments>;

    // Bytes from the texture's first: the left texels of both rows.
    alignas(64) Lanes first, second;
    // Of the right texels and of the second row, as AxisTexelVectors has them.
    alignas(64) Lanes weight_x, weight_y;
    // Of the vector that begins at a lane: none of its lanes meets a border, and each one's texels
    // of a row are neighbours. The others are left to filter_level().
    std::array<bool, BatchFragments> regular;
};

HWY_INLINE MI meets_border(const TexelPair& pair) {
    return hn::Or(pair.first.outside, pair.second.outside);
}

template <class K, bool Linear>
HWY_INLINE bool is_regular(const TexelPair& x, const TexelPair& y) {
    MI irregular = no_lanes();
    if constexpr (K::Border) irregular = hn::Or(meets_border(x), meets_border(y));
    if constexpr (Linear)
        irregular = hn::Or(irregular, hn::Ne(hn::Sub(x.second.index, x.first.index), constant(1)));
    return hn::AllFalse(DI(), irregular);
}

template <class K, bool Linear>
HWY_INLINE void place_texels(const TextureUnit& unit,
                             const FilterInputs& in,
                             const LevelVectors& level,
                             unsigned lane,
                             TexelPlaces& places) {
    const DI d;
    const TexelPair x = texel_pair<K, Linear>(unit, 0, in.coordinates->s.data() + lane, level.x);
    const TexelPair y = texel_pair<K, Linear>(unit, 1, in.coordinates->t.data() + lane, level.y);
    places.regular[lane] = is_regular<K, Linear>(x, y);
    const int shift = K::Texels::bytes(unit) / 2; // of 1, 2 or 4 bytes
    const VI left = hn::Add(level.offset, hn::ShiftLeftSame(x.first.index, shift));
    hn::Store(
        hn::Add(left, hn::Mul(y.first.index, level.row_stride)), d, places.first.data() + lane);
    if constexpr (!Linear) return;
    hn::Store(
        hn::Add(left, hn::Mul(y.second.index, level.row_stride)), d, places.second.data() + lane);
    hn::Store(x.weight, d, places.weight_x.data() + lane);
    hn::Store(y.weight, d, places.weight_y.data() + lane);
}

template <class D>
HWY_INLINE hn::Vec<D> broadcast_from(D d, const std::byte* from) {
    hn::TFromD<D> word;
    std::memcpy(&word, from, sizeof word);
    return hn::Set(d, word);
}

// Words of D's size at the places at[0 ..]; I counts D's lanes but the first.
template <class D, std::size_t... I>
HWY_INLINE hn::Vec<D>
words_at(D d, const std::byte* base, const std::int32_t* at, std::index_sequence<I...>) {
    using T = hn::TFromD<D>;
    const auto lanes = hn::Iota(d, 0);
    hn::Vec<D> words = broadcast_from(d, base + at[0]);
    ((words = hn::IfThenElse(hn::Eq(lanes, hn::Set(d, static_cast<T>(I + 1))),
                             broadcast_from(d, base + at[I + 1]),
                             words)),
     ...);
    return words;
}

// In two halves, of which neither waits for the other, where vectors are long.
template <class D>
HWY_INLINE hn::Vec<D> words_at(D d, const std::byte* base, const std::int32_t* at) {
    constexpr std::size_t Lanes = hn::MaxLanes(D());
    if constexpr (Lanes > 4) {
        const hn::Half<D> half;
        return hn::Combine(d, words_at(half, base, at + Lanes / 2), words_at(half, base, at));
    } else {
        return words_at(d, base, at, std::make_index_sequence<Lanes - 1>());
    }
}

// The texels at `at` and their neighbours to the right.
struct TexelsAt {
    VU left, right;
};

template <class Texels>
HWY_INLINE TexelsAt neighbours_at(const TextureUnit& unit, const std::int32_t* at) {
    const DU d;
    if constexpr (sizeof(typename Texels::Pair) == sizeof(std::uint32_t)) {
        const VU both = words_at(d, unit.texels, at);
        return {both, hn::ShiftRightSame(both, 8 * Texels::bytes(unit))};
    } else {
        const hn::RepartitionToWide<DU> pairs;
        const auto lower = hn::BitCast(d, words_at(pairs, unit.texels, at));
        const auto upper = hn::BitCast(d, words_at(pairs, unit.texels, at + hn::MaxLanes(pairs)));
        return {hn::ConcatEven(d, upper, lower), hn::ConcatOdd(d, upper, lower)};
    }
}

template <class Texels>
HWY_INLINE Color16 filter_row_at(const TextureUnit& unit, const std::int32_t* at, VI weight) {
    const TexelsAt texels = neighbours_at<Texels>(unit, at);
    const Color16 left = split(Texels::decode(unit, texels.left));
    return lerp8w(left, split(Texels::decode(unit, texels.right)), weight);
}

// What filter_level() gives, of regular places.
template <class K, bool Linear>
HWY_INLINE Color16 filter_places(const TextureUnit& unit,
                                 const TexelPlaces& places,
                                 unsigned lane) {
    using Texels = typename K::Texels;
    const std::int32_t* const first = places.first.data() + lane;
    if constexpr (!Linear) return split(Texels::decode(unit, words_at(DU(), unit.texels, first)));
    const VI weight = hn::Load(DI(), places.weight_x.data() + lane);
    return lerp8w(filter_row_at<Texels>(unit, first, weight),
                  filter_row_at<Texels>(unit, places.second.data() + lane, weight),
                  hn::Load(DI(), places.weight_y.data() + lane));
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
