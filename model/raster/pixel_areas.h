// The areas of a convex polygon inside the pixels of a row. Green's theorem: the sum over the edges
// of the area between the edge and the pixel's lower side, from left to right negative. Each edge
// is cut off at the pixel's left and right, and its height is held between the pixel's lower and
// upper side; what a straight line held so has below it is known in closed form.

#pragma once

#include "model/raster/setup_record.h"

#include <array>
#include <span>

namespace ffgpu {

constexpr unsigned AreaRow = 8; // pixels

// An edge that is not vertical, in pixels. Binary64, as all that follows.
struct AreaEdge {
    double x0, y0; // where it begins
    double x1;     // where it ends
    double slope;
};

struct AreaPolygon {
    unsigned count = 0;
    std::array<AreaEdge, MaxEdges> edges;
};

// Of a convex polygon with at most MaxEdges corners, counter-clockwise.
AreaPolygon make_area_polygon(std::span<const SubPixelPoint> corners);

using RowAreas = std::array<double, AreaRow>; // 0 to 1, but for rounding

// The pixels from (x, y) to the right.
void row_areas(const AreaPolygon& polygon, int x, int y, RowAreas& areas);

// The same, pixel by pixel: the specification.
void row_areas_scalar(const AreaPolygon& polygon, int x, int y, RowAreas& areas);

// Edges that rise or fall less inside a pixel count as level.
constexpr double LevelEdge = 0x1p-20;

} // namespace ffgpu
