// Edge functions: exact, in integers.
//
// Vertices lie on a grid of 1/256 pixel, pixel centres at 256 X + 128. The edge from p to q has the
// function E(x, y) = a (x - p.x) + b (y - p.y) with a = p.y - q.y and b = q.x - p.x, which is
// positive to the left of the edge: inside, for a counter-clockwise polygon with y up.
//
// A centre on an edge is inside where the edge is a left one (a > 0) or a lower one (a = 0, b > 0):
// a box covers x0 <= x < x1, y0 <= y < y1. Of two polygons that share an edge, one owns it.
//
// From a centre to the next E changes by a multiple of 256, so that E >= 0 can be decided on
// floor(E / 256): its steps are a and b, 23 bits with their sign. Samples beside the centres need
// the remainder as well.

#pragma once

#include "model/device/layout/limits.h"

#include <cstdint>

namespace ffgpu {

struct SubPixelPoint {
    std::int32_t x = 0, y = 0; // 24.8

    bool operator==(const SubPixelPoint&) const = default;
};

// Inside where at(X, Y) >= 0, X and Y being whole pixels.
struct Edge {
    std::int32_t a = 0, b = 0;
    std::int64_t c = 0;

    std::int64_t at(int x, int y) const { return std::int64_t{a} * x + std::int64_t{b} * y + c; }
};

// An edge with the bits that flooring drops: E anywhere, not at centres alone.
struct ExactEdge {
    Edge edge;
    std::uint8_t fraction = 0; // E at a centre is 256 edge.at() + fraction

    // The edge of those points that lie `by` (1/256 pixel) beside a centre.
    Edge moved(SubPixelPoint by) const {
        const std::int64_t change =
            fraction + std::int64_t{edge.a} * by.x + std::int64_t{edge.b} * by.y;
        return {edge.a, edge.b, edge.c + (change >> SubPixelBits)};
    }
};

inline ExactEdge make_exact_edge(SubPixelPoint p, SubPixelPoint q) {
    constexpr int Half = 1 << (SubPixelBits - 1);
    const std::int32_t a = p.y - q.y;
    const std::int32_t b = q.x - p.x;
    const bool owns_boundary = a > 0 || (a == 0 && b > 0);
    const std::int64_t at_centre = std::int64_t{a} * (Half - p.x) + std::int64_t{b} * (Half - p.y);
    const std::int64_t inside = at_centre - (owns_boundary ? 0 : 1);
    return {{a, b, inside >> SubPixelBits}, static_cast<std::uint8_t>(inside & 255)};
}

inline Edge make_edge(SubPixelPoint p, SubPixelPoint q) {
    return make_exact_edge(p, q).edge;
}

// Twice the signed area of a triangle, in units of (1/256 pixel)^2; positive: counter-clockwise.
inline std::int64_t double_area(SubPixelPoint p, SubPixelPoint q, SubPixelPoint r) {
    return std::int64_t{q.x - p.x} * (r.y - p.y) - std::int64_t{r.x - p.x} * (q.y - p.y);
}

} // namespace ffgpu
