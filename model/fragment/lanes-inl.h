// Vectors over the lanes of a FragmentBatch, compiled once a SIMD target.
// Arrays of a batch hold whole vectors: a loop may run beyond lanes() to the vector's end.

#if defined(FFGPU_FRAGMENT_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_FRAGMENT_LANES_INL_H_
#undef FFGPU_FRAGMENT_LANES_INL_H_
#else
#define FFGPU_FRAGMENT_LANES_INL_H_
#endif

#include "model/arith/lanes/mask_bits-inl.h"
#include "model/fragment/unorm8.h"
#include "model/packets/fragment_batch.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Channel values.
using D16 = hn::CappedTag<std::uint16_t, 32>;
using V16 = hn::Vec<D16>;
// Half as many wider lanes: depths, coordinates.
using DHalf16 = hn::Half<D16>;
using D32 = hn::Rebind<std::uint32_t, DHalf16>;
using V32 = hn::Vec<D32>;
using M32 = hn::Mask<D32>;

constexpr unsigned Lanes16 = hn::MaxLanes(D16());
constexpr unsigned Lanes32 = Lanes16 / 2;

HWY_INLINE V16 set16(unsigned value) {
    return hn::Set(D16(), static_cast<std::uint16_t>(value));
}

// round(product / 255) for products <= 65025.
HWY_INLINE V16 divide_by_255(V16 product) {
    const V16 t = hn::Add(product, set16(128));
    return hn::ShiftRight<8>(hn::Add(t, hn::ShiftRight<8>(t)));
}

// The same after a clamp of what may be more.
HWY_INLINE V16 clamp_and_divide_by_255(V16 product) {
    return divide_by_255(hn::Min(product, set16(Unorm8OneSquared)));
}

HWY_INLINE V16 complement(V16 value) {
    return hn::Xor(value, set16(255));
}

// Bits of `lanes` lanes from `lane` on, a multiple of `lanes`, which divides 64.
HWY_INLINE std::uint64_t mask_bits(const FragmentMask& mask, unsigned lane, unsigned lanes) {
    return mask.words[lane / 64] >> (lane % 64) & ((std::uint64_t{1} << lanes) - 1);
}

// Calls bits(lane) for each vector of Lanes lanes, and gathers the bits that it returns, of lanes
// that are among those. A mask that grew in memory would chain the iterations.
template <unsigned Lanes, class Bits>
HWY_INLINE FragmentMask collect_mask(const FragmentMask& among, unsigned lanes, Bits&& bits) {
    const auto word = [&](unsigned number) HWY_ATTR {
        const unsigned first = 64 * number, end = std::min(lanes, first + 64);
        std::uint64_t collected = 0;
        for (unsigned i = first; i < end; i += Lanes)
            collected |= bits(i) << (i - first);
        return collected & among.words[number];
    };
    static_assert(BatchFragments == 4 * 64);
    return FragmentMask::of(word(0), word(1), word(2), word(3));
}

HWY_INLINE FragmentMask both(FragmentMask a, const FragmentMask& b) {
    for (unsigned i = 0; i < a.words.size(); ++i)
        a.words[i] &= b.words[i];
    return a;
}

template <class D>
HWY_INLINE hn::Mask<D> mask_from_bits(D d, std::uint64_t bits) {
    std::uint8_t bytes[8];
    std::memcpy(bytes, &bits, sizeof bytes);
    return hn::LoadMaskBits(d, bytes);
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
