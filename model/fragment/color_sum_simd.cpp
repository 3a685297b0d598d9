#include "model/base/simd_targets.h"
#include "model/fragment/color_sum.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fragment/color_sum_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "model/fragment/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

void add_plane(const std::uint16_t* addend, std::uint16_t* sum, unsigned lanes) {
    const D16 d;
    for (unsigned i = 0; i < lanes; i += Lanes16)
        hn::Store(hn::Min(hn::Add(hn::Load(d, sum + i), hn::Load(d, addend + i)), set16(255)),
                  d,
                  sum + i);
}

void add_secondary_lanes(FragmentBatch& batch) {
    ColorPlanes& color = batch.color;
    add_plane(batch.secondary.r.data(), color.r.data(), batch.lanes());
    add_plane(batch.secondary.g.data(), color.g.data(), batch.lanes());
    add_plane(batch.secondary.b.data(), color.b.data(), batch.lanes());
}

void apply_coverage_lanes(FragmentBatch& batch) {
    const D16 d;
    std::uint16_t* alpha = batch.color.a.data();
    for (unsigned i = 0; i < batch.lanes(); i += Lanes16) {
        const V16 coverage = hn::Load(d, batch.antialias.data() + i);
        hn::Store(divide_by_255(hn::Mul(hn::Load(d, alpha + i), coverage)), d, alpha + i);
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(add_secondary_lanes);
HWY_EXPORT(apply_coverage_lanes);

void add_secondary(FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(add_secondary_lanes)(batch);
}
void apply_coverage(FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(apply_coverage_lanes)(batch);
}

} // namespace ffgpu
#endif
