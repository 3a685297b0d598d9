#include "model/fragment/alpha_test.h"
#include "model/fragment/simd_targets.h"

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
    FragmentMask passed;
    for (unsigned i = 0; i < batch.lanes(); i += Lanes16) {
        const auto alpha = hn::BitCast(d, hn::Load(D16(), batch.color.a.data() + i));
        const auto mask = compare_lanes(d, control.alpha_compare, alpha, reference);
        set_mask_bits(passed, i, bits_from_mask(d, mask) & mask_bits(batch.live, i, Lanes16));
    }
    return passed;
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
