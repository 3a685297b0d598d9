// Coverage of smooth primitives: the share of each pixel's square that lies inside.

#pragma once

#include "model/raster/quad_collector.h"

namespace ffgpu {

// The block at (x, y), for CoverageKind::SmoothPolygon and SmoothPoint: returns the pixels whose
// coverage, 0 .. 255, is not 0, and fills in theirs.
BlockMask smooth_block(const SetupRecord& record, int x, int y, BlockAntialias& coverage);

// The same, each pixel's area reckoned: the specification.
BlockMask smooth_block_scalar(const SetupRecord& record, int x, int y, BlockAntialias& coverage);

} // namespace ffgpu
