// The SIMD form of row_areas: a pixel a lane.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/pixel_areas.cpp"

#include "model/raster/pixel_areas.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Doubles = hn::CappedTag<double, AreaRow>;
using Vector = hn::Vec<Doubles>;

alignas(64) constexpr double PixelX[AreaRow] = {0, 1, 2, 3, 4, 5, 6, 7};

Vector hold(Vector value) {
    const Doubles d;
    return hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 1));
}

Vector area_below(const AreaEdge& edge, Vector x, double y) {
    const Doubles d;
    const Vector one = hn::Set(d, 1), half = hn::Set(d, 0.5);
    const Vector slope = hn::Set(d, edge.slope), level = hn::Set(d, edge.y0 - y);
    const Vector begin = hn::Sub(hn::Set(d, edge.x0), x);
    const Vector left = hold(begin), right = hold(hn::Sub(hn::Set(d, edge.x1), x));
    const Vector first = hn::Add(level, hn::Mul(hn::Sub(left, begin), slope));
    const Vector last = hn::Add(level, hn::Mul(hn::Sub(right, begin), slope));
    const Vector first_held = hold(first), last_held = hold(last);
    const Vector first_over = hn::Max(hn::Sub(first, one), hn::Zero(d));
    const Vector last_over = hn::Max(hn::Sub(last, one), hn::Zero(d));
    const Vector rise = hn::Sub(last, first);
    const Vector sum = hn::Add(first_held, last_held);
    const Vector integral = hn::Add(hn::Mul(hn::Mul(hn::Sub(last_held, first_held), sum), half),
                                    hn::Sub(last_over, first_over));
    const auto is_level = hn::Lt(hn::Abs(rise), hn::Set(d, LevelEdge));
    const Vector mean = hn::IfThenElse(is_level, hn::Mul(sum, half), hn::Div(integral, rise));
    return hn::Mul(hn::Sub(left, right), mean);
}

void AreasOfRow(const AreaPolygon& polygon, int x, int y, RowAreas& areas) {
    const Doubles d;
    for (std::size_t lane = 0; lane < AreaRow; lane += hn::Lanes(d)) {
        const Vector pixel =
            hn::Add(hn::Set(d, static_cast<double>(x)), hn::Load(d, PixelX + lane));
        Vector sum = hn::Zero(d);
        for (unsigned e = 0; e < polygon.count; ++e)
            sum = hn::Add(sum, area_below(polygon.edges[e], pixel, y));
        hn::StoreU(sum, d, areas.data() + lane);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(AreasOfRow);

void row_areas(const AreaPolygon& polygon, int x, int y, RowAreas& areas) {
    static const auto find = [] {
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        return HWY_DYNAMIC_DISPATCH(AreasOfRow);
    }();
    find(polygon, x, y, areas);
}

} // namespace ffgpu
#endif
