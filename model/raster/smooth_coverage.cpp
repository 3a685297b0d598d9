#include "model/raster/smooth_coverage.h"

#include "model/raster/pixel_areas.h"
#include "model/raster/smooth_block.h"

namespace ffgpu {

BlockMask smooth_block_scalar(const SetupRecord& record, int x, int y, BlockAntialias& coverage) {
    SmoothBlock block(record, x, y, coverage);
    const bool circle = record.coverage == CoverageKind::SmoothPoint;
    const AreaPolygon polygon =
        circle ? AreaPolygon{} : make_area_polygon({record.corners.data(), record.edge_count});
    for (int py = block.area.y0; py < block.area.y1; ++py) {
        RowAreas areas;
        row_areas_scalar(polygon, x, py, areas);
        for (int px = block.area.x0; px < block.area.x1; ++px)
            block.set(px,
                      py,
                      circle ? circle_coverage(record, px, py)
                             : coverage_value(areas[static_cast<std::size_t>(px - x)]));
    }
    return block.mask;
}

} // namespace ffgpu
