// The areas over one pixel, their specification; and the polygon that both forms read.

#include "model/raster/pixel_areas.h"

#include <cmath>

namespace ffgpu::one_pixel {
namespace {

using Doubles = double;
constexpr unsigned AreaLanes = 1;

Doubles splat(double value) {
    return value;
}
Doubles pixels_from(int x) {
    return x;
}
Doubles maximum(Doubles a, Doubles b) {
    return a > b ? a : b;
}
Doubles minimum(Doubles a, Doubles b) {
    return a < b ? a : b;
}
Doubles absolute(Doubles a) {
    return std::abs(a);
}
Doubles where_less(Doubles a, Doubles b, Doubles yes, Doubles no) {
    return a < b ? yes : no;
}
void store(Doubles value, double* to) {
    *to = value;
}

} // namespace
} // namespace ffgpu::one_pixel

#define FFGPU_LANES one_pixel
#include "model/raster/pixel_areas.inl"

namespace ffgpu {

AreaPolygon make_area_polygon(std::span<const SubPixelPoint> corners) {
    constexpr double One = 1 << SubPixelBits;
    AreaPolygon polygon;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const SubPixelPoint from = corners[i];
        const SubPixelPoint to = corners[i + 1 == corners.size() ? 0 : i + 1];
        if (from.x == to.x) continue;
        polygon.edges[polygon.count++] = {.x0 = from.x / One,
                                          .y0 = from.y / One,
                                          .x1 = to.x / One,
                                          .slope = static_cast<double>(to.y - from.y) /
                                                   static_cast<double>(to.x - from.x)};
    }
    return polygon;
}

void row_areas_scalar(const AreaPolygon& polygon, int x, int y, RowAreas& areas) {
    one_pixel::areas_of_row(polygon, x, y, areas);
}

} // namespace ffgpu
