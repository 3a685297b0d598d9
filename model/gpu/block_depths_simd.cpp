// The SIMD form of farthest_depth: a row of the block at once.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/gpu/block_depths_simd.cpp"

#include "model/gpu/block_depths.h"
#include "model/raster/coverage.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

template <class Word>
HWY_INLINE std::uint32_t greatest_word(const std::byte* row, std::size_t stride) {
    const hn::CappedTag<Word, BlockSize> d;
    auto most = hn::Zero(d);
    for (int y = 0; y < BlockSize; ++y, row += stride)
        for (std::size_t x = 0; x < BlockSize; x += hn::Lanes(d))
            most = hn::Max(most, hn::LoadU(d, reinterpret_cast<const Word*>(row) + x));
    return hn::GetLane(hn::MaxOfLanes(d, most));
}

std::uint32_t FarthestInRows(const std::byte* first, std::size_t stride, Format format) {
    if (format == Format::Depth16) return greatest_word<std::uint16_t>(first, stride);
    return greatest_word<std::uint32_t>(first, stride) >> 8; // over the stencil's bits
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(FarthestInRows);

FarthestInRows choose_farthest_in_rows() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(FarthestInRows);
}

} // namespace ffgpu
#endif
