#include "model/base/simd_targets.h"
#include "model/fragment/alpha_test.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fragment/alpha_test_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "model/fragment/compare_lanes-inl.h"
#include "model/fragment/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

FragmentMask alpha_test_lanes(const FragmentControl& control, const FragmentBatch& batch) {
    // Values below 2^15 compare the same as signed ones.
    const hn::RebindToSigned<D16> d;
    const auto reference = hn::Set(d, static_cast<std::int16_t>(control.alpha_reference));
    return collect_mask<Lanes16>(batch.live, batch.lanes(), [&](unsigned i) HWY_ATTR {
        const auto alpha = hn::BitCast(d, hn::Load(D16(), batch.color.a.data() + i));
        return bits_from_mask(d, compare_lanes(d, control.alpha_compare, alpha, reference));
    });
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(alpha_test_lanes);

FragmentMask alpha_test(const FragmentControl& control, const FragmentBatch& batch) {
    if (!control.alpha_test) return batch.live;
    return HWY_DYNAMIC_DISPATCH(alpha_test_lanes)(control, batch);
}

} // namespace ffgpu
#endif
