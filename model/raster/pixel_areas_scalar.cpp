#include "model/raster/pixel_areas.h"

#include <cmath>

namespace ffgpu {
namespace {

constexpr double One = 1 << SubPixelBits;

double hold(double value) {
    const double above = value > 0 ? value : 0;
    return above < 1 ? above : 1;
}

// What the edge has below it inside the pixel at (x, y).
double area_below(const AreaEdge& edge, double x, double y) {
    const double begin = edge.x0 - x;
    const double left = hold(begin), right = hold(edge.x1 - x);
    const double first = (edge.y0 - y) + (left - begin) * edge.slope;
    const double last = (edge.y0 - y) + (right - begin) * edge.slope;
    const double first_held = hold(first), last_held = hold(last);
    const double first_over = first > 1 ? first - 1 : 0, last_over = last > 1 ? last - 1 : 0;
    const double rise = last - first;
    const double sum = first_held + last_held;
    // The integral of the held height over the height, by the rise: the mean held height.
    const double integral = (last_held - first_held) * sum * 0.5 + (last_over - first_over);
    const double mean = std::abs(rise) < LevelEdge ? sum * 0.5 : integral / rise;
    return (left - right) * mean;
}

} // namespace

AreaPolygon make_area_polygon(std::span<const SubPixelPoint> corners) {
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
    areas.fill(0);
    for (unsigned e = 0; e < polygon.count; ++e)
        for (unsigned i = 0; i < AreaRow; ++i)
            areas[i] += area_below(polygon.edges[e], x + static_cast<int>(i), y);
}

} // namespace ffgpu
