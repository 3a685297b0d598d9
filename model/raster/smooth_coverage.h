// Coverage of smooth primitives: the share of each pixel's square that lies inside.

#pragma once

#include "model/raster/quad_collector.h"

namespace ffgpu {

// The block at (x, y), for CoverageKind::SmoothPolygon and SmoothPoint: fills `coverage` with
// 0 .. 255 and returns the pixels where it is not 0.
BlockMask smooth_block(const SetupRecord& record, int x, int y, BlockAntialias& coverage);

// Area of the convex polygon (counter-clockwise) inside the pixel, 0 to 1. Binary64.
double area_in_pixel(std::span<const SubPixelPoint> corners, int x, int y);

} // namespace ffgpu
