// The SIMD form of cover_tile: one vector operation an edge and 4 to 16 pixels.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/coverage_simd.cpp"

#include "model/raster/tile_walk.h"

#include <bit>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<std::int32_t, 16>;

constexpr unsigned QuadRow = 16; // The pixels of a block's two rows, in batch order.
alignas(64) constexpr std::int32_t LaneX[QuadRow] = {
    0, 1, 0, 1, 2, 3, 2, 3, 4, 5, 4, 5, 6, 7, 6, 7};
alignas(64) constexpr std::int32_t LaneY[QuadRow] = {
    0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1};

// What each edge adds from the lower left pixel to those of the lowest row of quads.
struct EdgeOffsets {
    alignas(64) std::int32_t lane[MaxEdges][QuadRow];
};

void prepare_offsets(const TileWalk& walk, EdgeOffsets& offsets) {
    const Lanes d;
    for (unsigned i = 0; i < walk.edge_count; ++i) {
        const auto a = hn::Set(d, walk.edges[i].a);
        const auto b = hn::Set(d, walk.edges[i].b);
        for (std::size_t lane = 0; lane < QuadRow; lane += hn::Lanes(d))
            hn::Store(hn::Add(hn::Mul(a, hn::Load(d, LaneX + lane)),
                              hn::Mul(b, hn::Load(d, LaneY + lane))),
                      d,
                      offsets.lane[i] + lane);
    }
}

// A bit a lane.
std::uint32_t negative_lanes(hn::Vec<Lanes> values) {
    const Lanes d;
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(d, hn::Lt(values, hn::Zero(d)), bytes);
    return static_cast<std::uint32_t>(bytes[0] | bytes[1] << 8);
}

// The pixels of the block at (x, y) that lie inside all edges.
BlockMask cover_block(const TileWalk& walk, const EdgeOffsets& offsets, int x, int y) {
    const Lanes d;
    std::int32_t e[MaxEdges]; // at the block's lower left pixel
    for (unsigned i = 0; i < walk.edge_count; ++i)
        e[i] = walk.edges[i].e + walk.edges[i].a * (x - walk.blocks.x0) +
               walk.edges[i].b * (y - walk.blocks.y0);
    BlockMask outside_mask = 0;
    for (unsigned row = 0; row < BlockQuadsAcross; ++row)
        for (std::size_t lane = 0; lane < QuadRow; lane += hn::Lanes(d)) {
            auto outside = hn::Zero(d); // The sign bits of all edges.
            for (unsigned i = 0; i < walk.edge_count; ++i) {
                const std::int32_t base =
                    e[i] + static_cast<std::int32_t>(2 * row) * walk.edges[i].b;
                outside =
                    hn::Or(outside, hn::Add(hn::Set(d, base), hn::Load(d, offsets.lane[i] + lane)));
            }
            outside_mask |= BlockMask{negative_lanes(outside)} << (row * QuadRow + lane);
        }
    return ~outside_mask;
}

// Blocks of a row of up to 16, a bit each from the left.
struct BlockRow {
    std::uint32_t outside; // lie outside an edge
    std::uint32_t partial; // do not lie inside all
};

// What each edge adds from a row's first block to the blocks of the row, a lane a block, for the
// pixel of a block where it is greatest and for that where it is least.
struct BlockOffsets {
    alignas(64) std::int32_t most[MaxEdges][QuadRow], least[MaxEdges][QuadRow];
};

void prepare_offsets(const TileWalk& walk, BlockOffsets& offsets) {
    const Lanes d;
    for (unsigned i = 0; i < walk.edge_count; ++i) {
        const TileEdge& edge = walk.edges[i];
        for (std::size_t lane = 0; lane < QuadRow; lane += hn::Lanes(d)) {
            const auto place = hn::Mul(hn::Set(d, edge.a * BlockSize),
                                       hn::Iota(d, static_cast<std::int32_t>(lane)));
            hn::Store(hn::Add(place, hn::Set(d, edge.gain())), d, offsets.most[i] + lane);
            hn::Store(hn::Add(place, hn::Set(d, edge.loss())), d, offsets.least[i] + lane);
        }
    }
}

// Lanes beyond the walk may wrap.
BlockRow classify_row(const TileWalk& walk, const BlockOffsets& offsets, int y) {
    const Lanes d;
    BlockRow row{};
    const auto blocks = static_cast<std::size_t>(walk.blocks.width() / BlockSize);
    for (std::size_t first = 0; first < blocks; first += hn::Lanes(d)) {
        auto outside = hn::Zero(d), partial = hn::Zero(d); // The sign bits of all edges.
        for (unsigned i = 0; i < walk.edge_count; ++i) {
            const auto at = hn::Set(d, walk.edges[i].e + walk.edges[i].b * (y - walk.blocks.y0));
            outside = hn::Or(outside, hn::Add(at, hn::Load(d, offsets.most[i] + first)));
            partial = hn::Or(partial, hn::Add(at, hn::Load(d, offsets.least[i] + first)));
        }
        row.outside |= negative_lanes(outside) << first;
        row.partial |= negative_lanes(partial) << first;
    }
    row.outside |= ~std::uint32_t{0} << blocks;
    return row;
}

bool is_small(const Rectangle& blocks) {
    return blocks.width() <= 2 * BlockSize && blocks.height() <= 2 * BlockSize;
}

void add_block(int x, int y, BlockMask mask, TileCoverage& coverage) {
    if (mask == 0) return;
    coverage.blocks[coverage.count++] = {
        static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), mask};
}

// An edge over the lanes of a row of quads.
struct RowEdge {
    hn::Vec<Lanes> at, up; // `up`: what the next row has more
};

// Pixels outside an edge: those of a block's rows of quads, as many as a vector has lanes.
template <std::size_t Count>
HWY_INLINE BlockMask rows_outside(std::array<RowEdge, Count>& edges) {
    BlockMask mask = 0;
    for (unsigned row = 0; row < BlockQuadsAcross; ++row) {
        auto outside = edges[0].at; // The sign bits of all edges.
        for (std::size_t i = 1; i < Count; ++i)
            outside = hn::Or(outside, edges[i].at);
        mask |= BlockMask{negative_lanes(outside)} << (row * QuadRow);
        for (RowEdge& edge : edges)
            edge.at = hn::Add(edge.at, edge.up);
    }
    return mask;
}

// Of a small primitive all blocks' pixels are evaluated, up to two blocks each way: to ask first
// which edge crosses which block would take longer.
template <std::size_t Count>
HWY_INLINE void cover_small(const TileWalk& walk, TileCoverage& coverage) {
    const Lanes d;
    for (int y = walk.blocks.y0; y < walk.blocks.y1; y += BlockSize)
        for (int x = walk.blocks.x0; x < walk.blocks.x1; x += BlockSize) {
            BlockMask outside = 0;
            for (std::size_t lane = 0; lane < QuadRow; lane += hn::Lanes(d)) {
                std::array<RowEdge, Count> edges;
                for (std::size_t i = 0; i < Count; ++i) {
                    const TileEdge& edge = walk.edges[i];
                    const std::int32_t e =
                        edge.e + edge.a * (x - walk.blocks.x0) + edge.b * (y - walk.blocks.y0);
                    const auto in_row =
                        hn::Add(hn::Mul(hn::Set(d, edge.a), hn::Load(d, LaneX + lane)),
                                hn::Mul(hn::Set(d, edge.b), hn::Load(d, LaneY + lane)));
                    edges[i] = {hn::Add(hn::Set(d, e), in_row), hn::Set(d, 2 * edge.b)};
                }
                outside |= rows_outside(edges) << lane;
            }
            add_block(x, y, rectangle_mask(walk.area, x, y) & ~outside, coverage);
        }
}

void cover_large(const TileWalk& walk, TileCoverage& coverage) {
    EdgeOffsets pixels;
    BlockOffsets blocks;
    prepare_offsets(walk, pixels);
    prepare_offsets(walk, blocks);
    for (int y = walk.blocks.y0; y < walk.blocks.y1; y += BlockSize) {
        const BlockRow row = classify_row(walk, blocks, y);
        for (std::uint32_t left = ~row.outside; left != 0; left &= left - 1) {
            const int column = std::countr_zero(left), x = walk.blocks.x0 + column * BlockSize;
            BlockMask mask = FullBlock;
            if ((row.partial >> column & 1) != 0) mask = cover_block(walk, pixels, x, y);
            if (!walk.holds(x, y)) mask &= rectangle_mask(walk.area, x, y);
            add_block(x, y, mask, coverage);
        }
    }
}

void CoverTile(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    coverage.count = 0;
    TileWalk walk;
    if (!begin_area(edges, tile, walk)) return;
    if (edges.edges.size() == 3 && is_small(walk.blocks)) {
        add_all_edges(edges, walk);
        cover_small<3>(walk, coverage);
    } else if (add_crossing_edges(edges, walk)) {
        cover_large(walk, coverage);
    }
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(CoverTile);

void cover_tile(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    // Chosen once: a call for each small triangle would feel Highway's own look-up.
    static const auto cover = [] {
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
        return HWY_DYNAMIC_DISPATCH(CoverTile);
    }();
    cover(edges, tile, coverage);
}

} // namespace ffgpu
#endif
