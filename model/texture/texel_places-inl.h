// The quick way to the texels of plain images whose texels are words: where all lanes of a batch
// read is found first, and stored; then their texels are loaded one by one, each put into its lane
// as it comes. Gathers are no quicker on any processor, and where they are microcode they take
// almost twice as long; and the loads of one vector need not wait for its own arithmetic.
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

// Kinds of texels that are words, of which a border is never met.
template <class K>
constexpr bool HasPlaces = K::Plain && !K::Border && requires { K::Texels::decode(VU()); };

// What a batch reads of one level. A nearest filter reads `first` alone.
struct TexelPlaces {
    using Lanes = std::array<std::int32_t, BatchFragments>;

    // Bytes from the texture's first: the left texels of both rows, and how far beyond them the
    // right ones are.
    alignas(64) Lanes first, second, apart;
    // Of the right texels and of the second row, as AxisTexelVectors has them.
    alignas(64) Lanes weight_x, weight_y;
};

template <bool Linear, class K>
HWY_INLINE void place_texels(const TextureUnit& unit,
                             const FilterInputs& in,
                             const LevelVectors& level,
                             unsigned lane,
                             TexelPlaces& places) {
    const DI d;
    const TexelPair x = texel_pair<K, Linear>(unit, 0, in.coordinates->s.data() + lane, level.x);
    const TexelPair y = texel_pair<K, Linear>(unit, 1, in.coordinates->t.data() + lane, level.y);
    const VI left = hn::Add(level.offset, hn::ShiftLeft<2>(x.first.index));
    const auto in_row = [&](const StoredIndex& row) HWY_ATTR {
        return hn::Add(left, hn::Mul(row.index, level.row_stride));
    };
    hn::Store(in_row(y.first), d, places.first.data() + lane);
    if constexpr (!Linear) return;
    hn::Store(in_row(y.second), d, places.second.data() + lane);
    const VI apart = hn::Sub(x.second.index, x.first.index);
    hn::Store(hn::ShiftLeft<2>(apart), d, places.apart.data() + lane);
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

// The texels at `at` and their neighbours to the right, in that order.
struct TexelsAt {
    VU left, right;
};

HWY_INLINE TexelsAt neighbours_at(const std::byte* base, const std::int32_t* at) {
    const DU d;
    const hn::RepartitionToWide<DU> pairs;
    const auto lower = hn::BitCast(d, words_at(pairs, base, at));
    const auto upper = hn::BitCast(d, words_at(pairs, base, at + hn::MaxLanes(pairs)));
    return {hn::ConcatEven(d, upper, lower), hn::ConcatOdd(d, upper, lower)};
}

HWY_INLINE TexelsAt texels_apart(const std::byte* base, const std::int32_t* at, VI apart) {
    alignas(64) std::int32_t right[hn::MaxLanes(DI())];
    hn::Store(hn::Add(hn::Load(DI(), at), apart), DI(), right);
    return {words_at(DU(), base, at), words_at(DU(), base, right)};
}

template <class K, bool Linear>
HWY_INLINE Color16 filter_places(const TextureUnit& unit,
                                 const TexelPlaces& places,
                                 unsigned lane) {
    using Texels = typename K::Texels;
    const DI d;
    const std::byte* const base = unit.texels;
    const std::int32_t* const first = places.first.data() + lane;
    if constexpr (!Linear) return split(Texels::decode(words_at(DU(), base, first)));
    const std::int32_t* const second = places.second.data() + lane;
    const VI weight_x = hn::Load(d, places.weight_x.data() + lane);
    const VI weight_y = hn::Load(d, places.weight_y.data() + lane);
    const auto rows = [&](const TexelsAt& upper, const TexelsAt& lower) HWY_ATTR {
        const auto row = [&](const TexelsAt& texels) HWY_ATTR {
            return lerp8w(split(Texels::decode(texels.left)),
                          split(Texels::decode(texels.right)),
                          weight_x);
        };
        return lerp8w(row(upper), row(lower), weight_y);
    };
    const VI apart = hn::Load(d, places.apart.data() + lane);
    if (hn::AllTrue(d, hn::Eq(apart, constant(sizeof(std::uint32_t)))))
        return rows(neighbours_at(base, first), neighbours_at(base, second));
    return rows(texels_apart(base, first, apart), texels_apart(base, second, apart));
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
