// Loads of words that lie at a place of each lane's own, as the texels of neighbouring pixels do.
// A load a lane, each put in its place as it comes: gathers do no better on any processor, and on
// those that carry them out in microcode they take almost twice as long.
// Included once for each instruction set.

#if defined(FFGPU_MODEL_TEXTURE_LANE_LOADS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_TEXTURE_LANE_LOADS_INL_H
#undef FFGPU_MODEL_TEXTURE_LANE_LOADS_INL_H
#else
#define FFGPU_MODEL_TEXTURE_LANE_LOADS_INL_H
#endif

#include "model/texture/axis-inl.h"

#include <cstddef>
#include <cstring>
#include <utility>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

// Each lane's place, in bytes from the first texel, where scalar loads find it.
struct LanePlaces {
    alignas(64) std::int32_t at[hn::MaxLanes(DI())];

    HWY_INLINE explicit LanePlaces(VI offset) {
        hn::Store(offset, DI(), at);
        asm("" : "+m"(at)); // Or compilers take the lanes out of the vector, which costs more.
    }
};

template <class D>
HWY_INLINE hn::Vec<D> broadcast_from(D d, const std::byte* from) {
    hn::TFromD<D> word;
    std::memcpy(&word, from, sizeof word);
    return hn::Set(d, word);
}

// Words of D's size at the places at[0 ..]; I is 0 .. one less than D has lanes.
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

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
