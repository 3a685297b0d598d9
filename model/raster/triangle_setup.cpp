// Filled polygons: three exact edges, or corners for area coverage.

#include "model/base/check.h"
#include "model/raster/plane_setup.h"
#include "model/raster/sample_positions.h"
#include "model/raster/shape_setup.h"

#include <algorithm>
#include <utility>

namespace ffgpu {
namespace {

struct Extent {
    std::int32_t low, high;
};

Extent extent(std::int32_t a, std::int32_t b, std::int32_t c) {
    return {std::min(std::min(a, b), c), std::max(std::max(a, b), c)};
}

// First pixel whose centre is at or beyond a sub-pixel coordinate: for low and high sides alike,
// as a box owns its lower and left boundary and not the other two.
int first_centre(std::int32_t at) {
    return (at + 127) >> SubPixelBits;
}

// Pixels of which any part may lie inside.
int first_touched(std::int32_t at) {
    return at >> SubPixelBits;
}
int last_touched_end(std::int32_t at) {
    return (at + 255) >> SubPixelBits;
}

// Pixels that a triangle of this extent may cover.
Rectangle reached_pixels(const SetupContext& context, Extent x, Extent y) {
    if (context.multisample) return sampled_pixels({x.low, y.low}, {x.high, y.high});
    if (context.primitive.polygon_smooth)
        return {first_touched(x.low),
                first_touched(y.low),
                last_touched_end(x.high),
                last_touched_end(y.high)};
    return {first_centre(x.low), first_centre(y.low), first_centre(x.high), first_centre(y.high)};
}

bool in_guard_band(const WindowVertex& v) {
    constexpr std::int32_t Limit = GuardBand << SubPixelBits;
    return v.x >= -Limit && v.x <= Limit && v.y >= -Limit && v.y <= Limit;
}

// The box has few pixels, and the triangle lies between their centres.
bool misses_its_box(const SetupRecord& record) {
    constexpr int Few = 2;
    const Rectangle& box = record.box;
    if (box.x1 - box.x0 > Few || box.y1 - box.y0 > Few) return false;
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            if ((record.edges[0].at(x, y) | record.edges[1].at(x, y) | record.edges[2].at(x, y)) >=
                0)
                return false;
    return true;
}

} // namespace

bool set_up_triangle(const SetupContext& context,
                     const Primitive& primitive,
                     SetupRecord& record,
                     bool all_planes) {
    const PlaneVertices& v = primitive.vertices;
    check(in_guard_band(*v[0]) && in_guard_band(*v[1]) && in_guard_band(*v[2]),
          "a vertex lies outside the guard band");

    const Extent x = extent(v[0]->x, v[1]->x, v[2]->x);
    const Extent y = extent(v[0]->y, v[1]->y, v[2]->y);
    record.box = intersect(reached_pixels(context, x, y), context.clip);
    if (record.box.empty()) return false;

    std::array<SubPixelPoint, 3> corner{
        {{v[0]->x, v[0]->y}, {v[1]->x, v[1]->y}, {v[2]->x, v[2]->y}}};
    const std::int64_t area = double_area(corner[0], corner[1], corner[2]);
    if (area == 0) return false;
    if (area < 0) std::swap(corner[1], corner[2]);
    record.set_edge(0, make_exact_edge(corner[0], corner[1]));
    record.set_edge(1, make_exact_edge(corner[1], corner[2]));
    record.set_edge(2, make_exact_edge(corner[2], corner[0]));
    record.edge_count = 3;
    if (context.multisample) record.coverage = CoverageKind::Samples;
    if (context.primitive.polygon_smooth) {
        record.coverage = CoverageKind::SmoothPolygon;
        std::copy(corner.begin(), corner.end(), record.corners.begin());
    }
    if (context.primitive.polygon_stipple) record.stipple = StippleKind::Polygon;

    record.covers_nothing = record.coverage == CoverageKind::Centre && misses_its_box(record);
    if (record.covers_nothing && !all_planes) return true;
    set_up_triangle_planes(context, v, record);
    if (context.primitive.offset_fill) add_depth_offset(context, v, triangle_basis(v), record);
    return true;
}

} // namespace ffgpu
