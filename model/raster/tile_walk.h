// TileWalk: a primitive's edges as one tile needs them.

#pragma once

#include "model/raster/coverage.h"

#include <algorithm>

namespace ffgpu {

struct TileEdge {
    std::int32_t a, b;
    std::int32_t e; // at the lower left pixel of the walk's first block

    std::int32_t at(int x, int y) const { return e + a * x + b * y; } // from there
    // Most and least that E can differ from its value at a block's lower left pixel.
    std::int32_t gain() const { return (BlockSize - 1) * (std::max(a, 0) + std::max(b, 0)); }
    std::int32_t loss() const { return (BlockSize - 1) * (std::min(a, 0) + std::min(b, 0)); }
};

struct TileWalk {
    Rectangle area;   // the primitive's box inside the tile
    Rectangle blocks; // around it, at multiples of BlockSize
    unsigned edge_count = 0;
    std::array<TileEdge, MaxEdges> edges; // those that cross the area

    // Whether the block at (x, y) lies wholly inside the area.
    bool holds(int x, int y) const {
        return x >= area.x0 && y >= area.y0 && x + BlockSize <= area.x1 && y + BlockSize <= area.y1;
    }
};

// Returns false where the primitive's box lies beside the tile.
inline bool begin_area(const EdgeSet& set, const Rectangle& tile, TileWalk& walk) {
    const Rectangle area = walk.area = intersect(set.box, tile);
    if (area.empty()) return false;
    constexpr int Mask = ~(BlockSize - 1);
    walk.blocks = {area.x0 & Mask,
                   area.y0 & Mask,
                   (area.x1 + BlockSize - 1) & Mask,
                   (area.y1 + BlockSize - 1) & Mask};
    return true;
}

// Returns false where the area lies outside an edge.
inline bool add_crossing_edges(const EdgeSet& set, TileWalk& walk) {
    const Rectangle& area = walk.area;
    for (const Edge& edge : set.edges) {
        const int right = area.x1 - 1, top = area.y1 - 1;
        const std::int64_t most = edge.at(edge.a > 0 ? right : area.x0, edge.b > 0 ? top : area.y0);
        if (most < 0) return false;
        const std::int64_t least =
            edge.at(edge.a > 0 ? area.x0 : right, edge.b > 0 ? area.y0 : top);
        if (least >= 0) continue;
        // The edge crosses the area: |E| stays below 2^31 in the whole tile.
        walk.edges[walk.edge_count++] = {
            edge.a, edge.b, static_cast<std::int32_t>(edge.at(walk.blocks.x0, walk.blocks.y0))};
    }
    return true;
}

// For areas of up to two blocks each way. E may lie far off where an edge does not cross them:
// beyond 2^30 its sign is the same in all, as steps are below 2^23.
inline void add_all_edges(const EdgeSet& set, TileWalk& walk) {
    constexpr std::int64_t Far = std::int64_t{1} << 30;
    for (const Edge& edge : set.edges) {
        const std::int64_t e = edge.at(walk.blocks.x0, walk.blocks.y0);
        walk.edges[walk.edge_count++] = {
            edge.a, edge.b, static_cast<std::int32_t>(std::clamp(e, -Far, Far))};
    }
}

} // namespace ffgpu
