#include "model/raster/sample_coverage.h"

namespace ffgpu {
namespace {

// Calls visit(block) for the blocks of the tile that the record's box touches, masks all 0.
template <class Visit>
void for_each_block(const SetupRecord& record, const Rectangle& tile, Visit&& visit) {
    const Rectangle area = intersect(record.box, tile);
    for (int y = area.y0 & -BlockSize; y < area.y1; y += BlockSize)
        for (int x = area.x0 & -BlockSize; x < area.x1; x += BlockSize)
            visit(SampleBlock{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), {}},
                  intersect(area, {x, y, x + BlockSize, y + BlockSize}));
}

// A sample on the circle is inside.
bool inside_circle(const SetupRecord& record, SubPixelPoint at) {
    const std::int64_t dx = at.x - record.corners[0].x, dy = at.y - record.corners[0].y;
    const std::int64_t radius = record.corners[1].x;
    return dx * dx + dy * dy <= radius * radius;
}

bool inside_edges(const SetupRecord& record, int x, int y, SubPixelPoint position) {
    for (unsigned i = 0; i < record.edge_count; ++i) {
        const Edge& edge = record.edges[i];
        const std::int64_t at_centre = (edge.at(x, y) << SubPixelBits) + record.edge_fractions[i];
        if (at_centre + std::int64_t{edge.a} * position.x + std::int64_t{edge.b} * position.y < 0)
            return false;
    }
    return true;
}

bool inside(const SetupRecord& record, int x, int y, SubPixelPoint position) {
    constexpr int One = 1 << SubPixelBits;
    return record.coverage == CoverageKind::SamplePoint
               ? inside_circle(record,
                               {x * One + One / 2 + position.x, y * One + One / 2 + position.y})
               : inside_edges(record, x, y, position);
}

} // namespace

void cover_tile_samples_scalar(const SetupRecord& record,
                               const Rectangle& tile,
                               TileSampleCoverage& coverage) {
    coverage.count = 0;
    for_each_block(record, tile, [&](SampleBlock block, const Rectangle& area) {
        for (int y = area.y0; y < area.y1; ++y)
            for (int x = area.x0; x < area.x1; ++x)
                for (unsigned i = 0; i < MaxSamples; ++i)
                    if (inside(record, x, y, SamplePositions[i]))
                        block.masks[i] |= BlockMask{1} << block_bit(x - block.x, y - block.y);
        if (block.any() != 0) coverage.blocks[coverage.count++] = block;
    });
}

} // namespace ffgpu
