// The areas by vectors, and only of the rows that an edge crosses.

#include "model/raster/pixel_areas.h"
#include "model/raster/smooth_block.h"
#include "model/raster/smooth_coverage.h"

#include <algorithm>
#include <cstdlib>

namespace ffgpu {
namespace {

void cover_point(const SetupRecord& record, SmoothBlock& block) {
    for (int y = block.area.y0; y < block.area.y1; ++y)
        for (int x = block.area.x0; x < block.area.x1; ++x)
            block.set(x, y, circle_coverage(record, x, y));
}

enum class Relation : std::uint8_t { Outside, Crossed, Inside };

// How the squares of the pixels (x, y) to (x + width - 1, y + height - 1) lie to the polygon, by
// the edges at the pixels' centres and their reach to the corners; the unit that flooring lost
// makes it no more than cautious.
Relation relation(const SetupRecord& record, int x, int y, int width, int height) {
    Relation result = Relation::Inside;
    for (unsigned i = 0; i < record.edge_count; ++i) {
        const std::int64_t a = record.edges[i].a, b = record.edges[i].b;
        const std::int64_t reach = (std::abs(a) + std::abs(b)) / 2 + 1;
        const std::int64_t along_x = a * (width - 1), along_y = b * (height - 1);
        const std::int64_t e = record.edges[i].at(x, y);
        const std::int64_t most =
            e + std::max<std::int64_t>(along_x, 0) + std::max<std::int64_t>(along_y, 0);
        const std::int64_t least =
            e + std::min<std::int64_t>(along_x, 0) + std::min<std::int64_t>(along_y, 0);
        if (most + reach < 0) return Relation::Outside;
        if (least - reach < 0) result = Relation::Crossed;
    }
    return result;
}

void cover_polygon(const SetupRecord& record, SmoothBlock& block) {
    const Relation whole = relation(record, block.x, block.y, BlockSize, BlockSize);
    if (whole == Relation::Outside) return;
    const AreaPolygon polygon = make_area_polygon({record.corners.data(), record.edge_count});
    RowAreas areas;
    for (int y = block.area.y0; y < block.area.y1; ++y) {
        areas.fill(1);
        if (whole == Relation::Crossed) {
            if (relation(record, block.x, y, BlockSize, 1) == Relation::Outside) continue;
            row_areas(polygon, block.x, y, areas);
        }
        for (int x = block.area.x0; x < block.area.x1; ++x)
            block.set(x, y, coverage_value(areas[static_cast<std::size_t>(x - block.x)]));
    }
}

} // namespace

BlockMask smooth_block(const SetupRecord& record, int x, int y, BlockAntialias& coverage) {
    SmoothBlock block(record, x, y, coverage);
    if (record.coverage == CoverageKind::SmoothPoint) {
        cover_point(record, block);
    } else {
        cover_polygon(record, block);
    }
    return block.mask;
}

} // namespace ffgpu
