#include "model/raster/stipple.h"

#include <algorithm>

namespace ffgpu {
namespace {

bool polygon_bit(const StipplePatterns& patterns, int x, int y) {
    const std::uint32_t row = patterns.polygon[static_cast<unsigned>(y) % 32];
    return row >> (31 - static_cast<unsigned>(x) % 32) & 1;
}

// GL 1.5, 3.4.2: bit floor(s / r) mod 16, s counting the fragments along the major axis.
bool line_bit(const SetupRecord& record, const StipplePatterns& patterns, int major) {
    const int steps = (major - record.stipple_start) * record.stipple_direction;
    const unsigned s = record.stipple_counter + static_cast<unsigned>(steps > 0 ? steps : 0);
    return patterns.line >> (s / patterns.line_factor % 16) & 1;
}

} // namespace

StipplePatterns stipple_patterns(const PolygonStipple& polygon, const PrimitiveSetup& primitive) {
    return {polygon.rows,
            primitive.line_stipple_pattern,
            std::max<std::uint16_t>(1, primitive.line_stipple_factor)};
}

BlockMask stipple_mask(const SetupRecord& record, const StipplePatterns& patterns, int x, int y) {
    if (record.stipple == StippleKind::None) return FullBlock;
    BlockMask mask = 0;
    for (int py = 0; py < BlockSize; ++py)
        for (int px = 0; px < BlockSize; ++px) {
            const bool kept =
                record.stipple == StippleKind::Polygon
                    ? polygon_bit(patterns, x + px, y + py)
                    : line_bit(
                          record, patterns, record.stipple == StippleKind::LineX ? x + px : y + py);
            if (kept) mask |= BlockMask{1} << block_bit(px, py);
        }
    return mask;
}

} // namespace ffgpu
