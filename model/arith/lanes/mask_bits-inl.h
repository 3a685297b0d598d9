// A mask of a vector comparison as a number, compiled once a SIMD target.

#if defined(FFGPU_ARITH_MASK_BITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_ARITH_MASK_BITS_INL_H_
#undef FFGPU_ARITH_MASK_BITS_INL_H_
#else
#define FFGPU_ARITH_MASK_BITS_INL_H_
#endif

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// The smallest number with a bit a lane.
template <std::size_t Lanes>
using MaskWord = std::conditional_t<
    Lanes <= 8,
    std::uint8_t,
    std::conditional_t<Lanes <= 16,
                       std::uint16_t,
                       std::conditional_t<Lanes <= 32, std::uint32_t, std::uint64_t>>>;

// A bit a lane, the first one lowest; zero beyond the lanes.
template <class D>
HWY_INLINE std::uint64_t bits_from_mask(D d, hn::Mask<D> mask) {
    MaskWord<hn::MaxLanes(D())> word;
    std::array<std::uint8_t, sizeof word> bytes;
    hn::StoreMaskBits(d, mask, bytes.data());
    std::memcpy(&word, bytes.data(), sizeof word);
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    // GCC 12 makes one operation of an AVX-512 comparison and the widening of its mask, and then
    // splits it into a comparison that leaves the upper bits as they were: where the number has to
    // wait in memory, they are what was there before (docs/decisions/0015-masks-as-numbers.md).
    asm("" : "+r"(word));
#endif
    return word;
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
