// What both forms of the coverage of smooth primitives share: a block as it fills, and the circle.

#pragma once

#include "model/raster/smooth_coverage.h"

#include <algorithm>
#include <cmath>

namespace ffgpu {

inline std::uint8_t coverage_value(double share) {
    return static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255 + 0.5);
}

// The circle's edge falls off over one pixel along the radius.
inline std::uint8_t circle_coverage(const SetupRecord& record, int x, int y) {
    constexpr double One = 1 << SubPixelBits;
    const double dx = (x + 0.5) - record.corners[0].x / One;
    const double dy = (y + 0.5) - record.corners[0].y / One;
    const double radius = record.corners[1].x / One;
    return coverage_value(radius + 0.5 - std::sqrt(dx * dx + dy * dy));
}

struct SmoothBlock {
    int x, y;
    Rectangle area; // those pixels that count
    BlockAntialias& coverage;
    BlockMask mask = 0;

    SmoothBlock(const SetupRecord& record, int at_x, int at_y, BlockAntialias& out)
        : x(at_x)
        , y(at_y)
        , area(intersect(record.box, {x, y, x + BlockSize, y + BlockSize}))
        , coverage(out) {}

    void set(int px, int py, std::uint8_t value) {
        const unsigned bit = block_bit(px - x, py - y);
        coverage[bit] = value;
        if (value != 0) mask |= BlockMask{1} << bit;
    }
};

} // namespace ffgpu
