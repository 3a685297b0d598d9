#include "model/raster/smooth_coverage.h"

#include <algorithm>
#include <cmath>

namespace ffgpu {
namespace {

constexpr double One = 1 << SubPixelBits;

struct Point {
    double x, y;
};

// Each side of the square may add a corner.
struct ClippedPolygon {
    unsigned count = 0;
    std::array<Point, 16> points; // Rounding can make a few more.

    void add(Point point) {
        if (count < points.size()) points[count++] = point;
    }
};

// The part where side(point) >= 0; `side` is linear.
template <class Side>
ClippedPolygon clip(const ClippedPolygon& polygon, Side&& side) {
    ClippedPolygon kept;
    for (unsigned i = 0; i < polygon.count; ++i) {
        const Point from = polygon.points[i], to = polygon.points[(i + 1) % polygon.count];
        const double at_from = side(from), at_to = side(to);
        if (at_from >= 0) kept.add(from);
        if ((at_from >= 0) != (at_to >= 0)) {
            const double t = at_from / (at_from - at_to);
            kept.add({from.x + (to.x - from.x) * t, from.y + (to.y - from.y) * t});
        }
    }
    return kept;
}

double area(const ClippedPolygon& polygon) {
    double twice = 0;
    for (unsigned i = 0; i < polygon.count; ++i) {
        const Point a = polygon.points[i], b = polygon.points[(i + 1) % polygon.count];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

std::uint8_t coverage_value(double share) {
    return static_cast<std::uint8_t>(std::clamp(share, 0.0, 1.0) * 255 + 0.5);
}

enum class Relation : std::uint8_t { Outside, Crossed, Inside };

// How a pixel's square lies to the polygon, by the edges at its centre and their reach to the
// corners; the unit that flooring lost makes it no more than cautious.
Relation relation(const SetupRecord& record, int x, int y) {
    Relation result = Relation::Inside;
    for (unsigned i = 0; i < record.edge_count; ++i) {
        const Edge& edge = record.edges[i];
        const std::int64_t reach =
            (std::int64_t{std::abs(edge.a)} + std::int64_t{std::abs(edge.b)}) / 2 + 1;
        const std::int64_t e = edge.at(x, y);
        if (e + reach < 0) return Relation::Outside;
        if (e - reach < 0) result = Relation::Crossed;
    }
    return result;
}

std::uint8_t polygon_coverage(const SetupRecord& record, int x, int y) {
    switch (relation(record, x, y)) {
    case Relation::Outside:
        return 0;
    case Relation::Inside:
        return 255;
    case Relation::Crossed:
        break;
    }
    return coverage_value(area_in_pixel({record.corners.data(), record.edge_count}, x, y));
}

// The circle's edge falls off over one pixel along the radius.
std::uint8_t circle_coverage(const SetupRecord& record, int x, int y) {
    const double dx = (x + 0.5) - record.corners[0].x / One;
    const double dy = (y + 0.5) - record.corners[0].y / One;
    const double radius = record.corners[1].x / One;
    return coverage_value(radius + 0.5 - std::sqrt(dx * dx + dy * dy));
}

} // namespace

double area_in_pixel(std::span<const SubPixelPoint> corners, int x, int y) {
    ClippedPolygon polygon;
    for (const SubPixelPoint& corner : corners)
        polygon.add({corner.x / One - x, corner.y / One - y});
    polygon = clip(polygon, [](Point p) { return p.x; });
    polygon = clip(polygon, [](Point p) { return 1 - p.x; });
    polygon = clip(polygon, [](Point p) { return p.y; });
    polygon = clip(polygon, [](Point p) { return 1 - p.y; });
    return area(polygon);
}

BlockMask smooth_block(const SetupRecord& record, int x, int y, BlockAntialias& coverage) {
    BlockMask mask = 0;
    const Rectangle area = intersect(record.box, {x, y, x + BlockSize, y + BlockSize});
    for (int py = area.y0; py < area.y1; ++py)
        for (int px = area.x0; px < area.x1; ++px) {
            const unsigned bit = block_bit(px - x, py - y);
            coverage[bit] = record.coverage == CoverageKind::SmoothPoint
                                ? circle_coverage(record, px, py)
                                : polygon_coverage(record, px, py);
            if (coverage[bit] != 0) mask |= BlockMask{1} << bit;
        }
    return mask;
}

} // namespace ffgpu
