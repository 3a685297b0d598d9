#include "model/raster/coverage.h"

#include <algorithm>

namespace ffgpu {
namespace {

bool inside(std::span<const Edge> edges, int x, int y) {
    return std::all_of(
        edges.begin(), edges.end(), [x, y](const Edge& edge) { return edge.at(x, y) >= 0; });
}

} // namespace

void cover_tile_scalar(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    coverage.count = 0;
    const Rectangle area = intersect(edges.box, tile);
    for (int by = tile.y0; by < tile.y1; by += BlockSize)
        for (int bx = tile.x0; bx < tile.x1; bx += BlockSize) {
            BlockMask mask = 0;
            for (int y = by; y < by + BlockSize; ++y)
                for (int x = bx; x < bx + BlockSize; ++x)
                    if (x >= area.x0 && x < area.x1 && y >= area.y0 && y < area.y1 &&
                        inside(edges.edges, x, y))
                        mask |= BlockMask{1} << block_bit(x - bx, y - by);
            if (mask != 0)
                coverage.blocks[coverage.count++] = {
                    static_cast<std::uint16_t>(bx), static_cast<std::uint16_t>(by), mask};
        }
}

// Pixel by pixel.
void cover_windows_scalar(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    coverage.count = 0;
    const Rectangle area = intersect(edges.box, tile);
    if (area.empty()) return;
    for (int wy = area.y0 & ~1; wy < area.y1; wy += BlockSize)
        for (int wx = area.x0 & ~1; wx < area.x1; wx += BlockSize) {
            const Rectangle window = intersect(area, {wx, wy, wx + BlockSize, wy + BlockSize});
            BlockMask mask = 0;
            for (int y = window.y0; y < window.y1; ++y)
                for (int x = window.x0; x < window.x1; ++x)
                    if (inside(edges.edges, x, y))
                        mask |= BlockMask{1} << block_bit(x - wx, y - wy);
            if (mask != 0)
                coverage.blocks[coverage.count++] = {
                    static_cast<std::uint16_t>(wx), static_cast<std::uint16_t>(wy), mask};
        }
}

std::uint32_t touched_blocks(const EdgeSet& edges) {
    constexpr int Last = BlockSize - 1;
    std::uint32_t touched = 0;
    for (int y = edges.box.y0 / BlockSize * BlockSize; y < edges.box.y1; y += BlockSize)
        for (int x = edges.box.x0 / BlockSize * BlockSize; x < edges.box.x1; x += BlockSize)
            touched += std::all_of(edges.edges.begin(), edges.edges.end(), [&](const Edge& edge) {
                return edge.at(edge.a > 0 ? x + Last : x, edge.b > 0 ? y + Last : y) >= 0;
            });
    return touched;
}

bool may_touch(const SetupRecord& record, const Rectangle& tile) {
    const Rectangle area = intersect(record.box, tile);
    if (area.empty()) return false;
    for (unsigned i = 0; i < record.edge_count; ++i) {
        const Edge& edge = record.edges[i];
        // An edge of a smooth polygon, or one of samples, reaches half a pixel further in both
        // directions.
        const std::int64_t reach =
            record.coverage == CoverageKind::Centre
                ? 0
                : (std::int64_t{edge.a < 0 ? -edge.a : edge.a} + (edge.b < 0 ? -edge.b : edge.b)) /
                          2 +
                      1;
        const std::int64_t most =
            edge.at(edge.a > 0 ? area.x1 - 1 : area.x0, edge.b > 0 ? area.y1 - 1 : area.y0);
        if (most + reach < 0) return false;
    }
    return true;
}

} // namespace ffgpu
