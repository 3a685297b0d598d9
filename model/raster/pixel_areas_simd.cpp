// The areas over vectors of pixels.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/pixel_areas_simd.cpp"

#include "model/raster/pixel_areas.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using AreaTag = hn::CappedTag<double, AreaRow>;
using Doubles = hn::Vec<AreaTag>;
constexpr unsigned AreaLanes = static_cast<unsigned>(hn::MaxLanes(AreaTag()));

inline Doubles splat(double value) {
    return hn::Set(AreaTag(), value);
}
inline Doubles pixels_from(int x) {
    return hn::Iota(AreaTag(), static_cast<double>(x));
}
inline Doubles maximum(Doubles a, Doubles b) {
    return hn::Max(a, b);
}
inline Doubles minimum(Doubles a, Doubles b) {
    return hn::Min(a, b);
}
inline Doubles absolute(Doubles a) {
    return hn::Abs(a);
}
inline Doubles where_less(Doubles a, Doubles b, Doubles yes, Doubles no) {
    return hn::IfThenElse(hn::Lt(a, b), yes, no);
}
inline void store(Doubles value, double* to) {
    hn::StoreU(value, AreaTag(), to);
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu

#undef FFGPU_LANES
#define FFGPU_LANES HWY_NAMESPACE
#include "model/raster/pixel_areas.inl"
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(areas_of_row);

void row_areas(const AreaPolygon& polygon, int x, int y, RowAreas& areas) {
    static const auto find = [] {
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        return HWY_DYNAMIC_DISPATCH(areas_of_row);
    }();
    find(polygon, x, y, areas);
}

} // namespace ffgpu
#endif
