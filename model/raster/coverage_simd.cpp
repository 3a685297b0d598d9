// The SIMD form of cover_tile: one vector operation an edge and 4 to 16 pixels.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/coverage_simd.cpp"

#include "model/raster/tile_walk.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format off: after foreach_target.h
#include "model/arith/lanes/mask_bits-inl.h"
// clang-format on

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
    return static_cast<std::uint32_t>(bits_from_mask(d, hn::Lt(values, hn::Zero(d))));
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

void add_block(int x, int y, BlockMask mask, TileCoverage& coverage) {
    if (mask == 0) return;
    coverage.blocks[coverage.count++] = {
        static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), mask};
}

// Small primitives: up to two blocks each way, whose edges' values differ by less than 2^15 in a
// block, so that 16 bits hold all that matters.
using Narrow = hn::CappedTag<std::int16_t, 2 * QuadRow>;
constexpr std::size_t NarrowLanes = hn::MaxLanes(Narrow());
constexpr std::size_t BlockVectors = BlockSize * BlockSize / NarrowLanes;

struct BlockPlaces {
    alignas(64) std::int16_t x[BlockSize * BlockSize]{}, y[BlockSize * BlockSize]{};

    constexpr BlockPlaces() {
        for (int py = 0; py < BlockSize; ++py)
            for (int px = 0; px < BlockSize; ++px) {
                x[block_bit(px, py)] = static_cast<std::int16_t>(px);
                y[block_bit(px, py)] = static_cast<std::int16_t>(py);
            }
    }
};
constexpr BlockPlaces Places;

bool has_few_blocks(const Rectangle& blocks) {
    return blocks.width() <= 2 * BlockSize && blocks.height() <= 2 * BlockSize;
}

bool has_small_steps(const TileWalk& walk) {
    int steepest = 0;
    for (unsigned i = 0; i < walk.edge_count; ++i)
        steepest = std::max(steepest, std::abs(walk.edges[i].a) + std::abs(walk.edges[i].b));
    return steepest <= SteepestInWindow;
}

// A bit a lane.
HWY_INLINE BlockMask negative_narrow(hn::Vec<Narrow> values) {
    return bits_from_mask(Narrow(), hn::Lt(values, hn::Zero(Narrow())));
}

// Three edges over 8x8 pixels at a time, from the lower left pixel of the first. An edge that is
// cut off at 16 bits keeps its sign: what it adds in a block is less.
class WindowEdges {
public:
    template <class AnyEdge>
    HWY_INLINE WindowEdges(const AnyEdge* edges, int x, int y) {
        const Narrow d;
        for (unsigned i = 0; i < Edges; ++i) {
            a_[i] = edges[i].a;
            b_[i] = edges[i].b;
            first_[i] = edges[i].at(x, y);
            const auto a = hn::Set(d, static_cast<std::int16_t>(a_[i]));
            const auto b = hn::Set(d, static_cast<std::int16_t>(b_[i]));
            for (std::size_t part = 0; part < BlockVectors; ++part)
                inside_[i][part] = hn::Add(hn::Mul(a, hn::Load(d, Places.x + part * NarrowLanes)),
                                           hn::Mul(b, hn::Load(d, Places.y + part * NarrowLanes)));
        }
    }
    // The pixels outside any edge, of those from (x, y) on.
    HWY_INLINE BlockMask outside(int x, int y) const {
        constexpr std::int64_t Limit = 0x7fff;
        hn::Vec<Narrow> first[Edges];
        for (unsigned i = 0; i < Edges; ++i) {
            const std::int64_t e = first_[i] + a_[i] * x + b_[i] * y;
            first[i] =
                hn::Set(Narrow(), static_cast<std::int16_t>(std::clamp(e, -Limit - 1, Limit)));
        }
        BlockMask mask = 0;
        for (std::size_t part = 0; part < BlockVectors; ++part) {
            const auto sum = [&](unsigned i)
                                 HWY_ATTR { return hn::SaturatedAdd(first[i], inside_[i][part]); };
            mask |= negative_narrow(hn::Or(hn::Or(sum(0), sum(1)), sum(2))) << (part * NarrowLanes);
        }
        return mask;
    }

private:
    static constexpr unsigned Edges = 3;
    hn::Vec<Narrow> inside_[Edges][BlockVectors]; // what each pixel has more than the first
    std::int32_t a_[Edges], b_[Edges];
    std::int64_t first_[Edges];
};

// All blocks' pixels are evaluated: to ask first which edge crosses which block would take longer.
HWY_INLINE void cover_small(const TileWalk& walk, TileCoverage& coverage) {
    const WindowEdges edges(walk.edges.data(), 0, 0);
    for (int y = walk.blocks.y0; y < walk.blocks.y1; y += BlockSize)
        for (int x = walk.blocks.x0; x < walk.blocks.x1; x += BlockSize) {
            const BlockMask outside = edges.outside(x - walk.blocks.x0, y - walk.blocks.y0);
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
    if (edges.edges.size() == 3 && has_few_blocks(walk.blocks)) {
        add_all_edges(edges, walk);
        if (has_small_steps(walk)) return cover_small(walk, coverage);
        walk.edge_count = 0;
    }
    if (add_crossing_edges(edges, walk)) cover_large(walk, coverage);
}

void CoverWindows(const EdgeSet& set, const Rectangle& tile, TileCoverage& coverage) {
    const Rectangle area = intersect(set.box, tile);
    coverage.count = 0;
    if (area.empty()) return;
    const int left = area.x0 & ~1, bottom = area.y0 & ~1;
    const WindowEdges edges(set.edges.data(), left, bottom);
    for (int y = bottom; y < area.y1; y += BlockSize)
        for (int x = left; x < area.x1; x += BlockSize) {
            const BlockMask outside = edges.outside(x - left, y - bottom);
            add_block(x, y, rectangle_mask(area, x, y) & ~outside, coverage);
        }
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(CoverTile);

CoverTileForm choose_cover_tile() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(CoverTile);
}

HWY_EXPORT(CoverWindows);

CoverTileForm choose_cover_windows() {
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return HWY_DYNAMIC_DISPATCH(CoverWindows);
}

namespace {

// Chosen before any is called: for each small triangle a look-up, or the guard of one that is done
// once, would be felt.
const CoverTileForm ChosenCoverTile = choose_cover_tile();
const CoverTileForm ChosenCoverWindows = choose_cover_windows();

} // namespace

void cover_tile(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    ChosenCoverTile(edges, tile, coverage);
}

void cover_windows(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    ChosenCoverWindows(edges, tile, coverage);
}

} // namespace ffgpu
#endif
