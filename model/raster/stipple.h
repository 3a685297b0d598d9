// Stipples: patterns that take pixels out of a covered block.

#pragma once

#include "model/device/registers/primitive.h"
#include "model/raster/coverage.h"

namespace ffgpu {

struct StipplePatterns {
    std::array<std::uint32_t, 32> polygon; // PolygonStipple::rows
    std::uint16_t line;
    std::uint16_t line_factor; // 1 to 256
};

StipplePatterns stipple_patterns(const PolygonStipple& polygon, const PrimitiveSetup& primitive);

// The pixels of the block at (x, y) that the record's stipple keeps.
BlockMask stipple_mask(const SetupRecord& record, const StipplePatterns& patterns, int x, int y);

} // namespace ffgpu
