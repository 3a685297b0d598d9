// Coverage and depth.

#include "Vdepth_plane.h"
#include "Vtile_walker.h"
#include "rtl/bundles/plane.h"
#include "rtl/bundles/tile.h"
#include "rtl/loop/loop_stages.h"
#include "rtl/loop/unit_driver.h"

#include <bit>

namespace ffgpu::rtl {
namespace {

// The unit walks 16 blocks, a cycle each, before it says that it has done.
struct TileWalkerUnit {
    static constexpr const char* Name = "tile_walker";
    static constexpr unsigned QuietCycles = 3;
    using Dut = Vtile_walker;
    using State = NoState;
    using Input = TileEdges;
    using Output = CoveredQuad;
};

struct DepthPlaneUnit : OneToOne<DepthPlaneQuad> {
    static constexpr const char* Name = "depth_plane";
    using Dut = Vdepth_plane;
    using State = NoState;
    using Input = DepthPlaneQuad;
    using Output = LaneDepths;
};

TileEdges edges_in(const EdgeSet& set, const Rectangle& box) {
    TileEdges edges{.box_x0 = static_cast<std::uint16_t>(box.x0),
                    .box_y0 = static_cast<std::uint16_t>(box.y0),
                    .box_x1 = static_cast<std::uint16_t>(box.x1),
                    .box_y1 = static_cast<std::uint16_t>(box.y1),
                    .edge_count = static_cast<std::uint8_t>(set.edges.size())};
    for (unsigned i = 0; i < set.edges.size(); ++i) {
        edges.a[i] = set.edges[i].a;
        edges.b[i] = set.edges[i].b;
        edges.c[i] = set.edges[i].c;
    }
    return edges;
}

// The model's tiles may be of another size than the unit's.
std::vector<TileEdges> unit_tiles(const EdgeSet& set, const Rectangle& tile) {
    std::vector<TileEdges> tiles;
    TileEdges edges = edges_in(set, intersect(set.box, tile));
    for (int y = tile.y0 / TileSize * TileSize; y < edges.box_y1; y += TileSize)
        for (int x = tile.x0 / TileSize * TileSize; x < edges.box_x1; x += TileSize) {
            if (x + TileSize <= edges.box_x0 || y + TileSize <= edges.box_y0) continue;
            edges.tile_x = static_cast<std::uint16_t>(x);
            edges.tile_y = static_cast<std::uint16_t>(y);
            tiles.push_back(edges);
        }
    return tiles;
}

// Blocks of a tile, or a primitive's windows, row by row, as the stage gives them.
class Blocks {
public:
    explicit Blocks(const Rectangle& tile)
        : tile_(tile)
        , across_((tile.x1 - tile.x0) / BlockSize) {}

    void add(const CoveredQuad& quad) {
        // What a faulty unit puts elsewhere is missing here.
        if (quad.x < tile_.x0 || quad.x >= tile_.x1 || quad.y < tile_.y0 || quad.y >= tile_.y1)
            return;
        if (((quad.x | quad.y) & 1) != 0) return;
        const auto x = static_cast<unsigned>(quad.x - tile_.x0) % 8;
        const auto y = static_cast<unsigned>(quad.y - tile_.y0) % 8;
        masks_[number(quad.x, quad.y)] |= BlockMask{quad.live} << 4 * (y / 2 * 4 + x / 2);
    }
    BlockMask at(int x, int y) const { return masks_[number(x, y)]; }

    void take(TileCoverage& coverage) const {
        coverage.count = 0;
        for (int y = tile_.y0; y < tile_.y1; y += BlockSize)
            for (int x = tile_.x0; x < tile_.x1; x += BlockSize)
                if (at(x, y) != 0)
                    coverage.blocks[coverage.count++] = {
                        static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), at(x, y)};
    }

private:
    std::size_t number(int x, int y) const {
        const int place = (y - tile_.y0) / BlockSize * across_ + (x - tile_.x0) / BlockSize;
        return static_cast<std::size_t>(place);
    }

    Rectangle tile_;
    int across_;
    std::array<BlockMask, MaxTileBlocks> masks_{};
};

// Of a block, lane by lane; the bits of a quad's lanes stand together.
void compare_block(int x, int y, BlockMask expected, BlockMask got) {
    if (expected == got) return;
    const auto bit = static_cast<unsigned>(std::countr_zero(expected ^ got));
    const unsigned quad = bit / 4;
    compare_lane({.unit = TileWalkerUnit::Name,
                  .field = {},
                  .x = static_cast<unsigned>(x) + quad % 4 * 2,
                  .y = static_cast<unsigned>(y) + quad / 4 * 2,
                  .lane = bit % 4},
                 "live",
                 expected >> bit & 1,
                 got >> bit & 1);
}

// `coverage` has the model's blocks, which lie in the grid, and gets the unit's.
void take_coverage(const EdgeSet& edges,
                   const Rectangle& tile,
                   const Rectangle& grid,
                   TileCoverage& coverage) {
    Blocks expected(grid), got(grid);
    std::uint64_t fragments = 0;
    for (unsigned i = 0; i < coverage.count; ++i) {
        const BlockCoverage& block = coverage.blocks[i];
        fragments += static_cast<std::uint64_t>(std::popcount(block.mask));
        for (unsigned quad = 0; quad < 16; ++quad)
            expected.add({.x = static_cast<std::uint16_t>(block.x + quad % 4 * 2),
                          .y = static_cast<std::uint16_t>(block.y + quad / 4 * 2),
                          .live = static_cast<std::uint8_t>(block.mask >> 4 * quad & 0xf)});
    }
    for (const CoveredQuad& quad : unit<TileWalkerUnit>().run({}, unit_tiles(edges, tile)))
        got.add(quad);
    for (int y = grid.y0; y < grid.y1; y += BlockSize)
        for (int x = grid.x0; x < grid.x1; x += BlockSize)
            compare_block(x, y, expected.at(x, y), got.at(x, y));
    got.take(coverage);
    loop_log().count(TileWalkerUnit::Name, "", fragments);
}

DepthPlaneQuad plane_quad(const SetupRecord& record, const FragmentBatch& batch, unsigned q) {
    return {.x = static_cast<std::int16_t>(batch.x[q] - record.x_reference),
            .y = static_cast<std::int16_t>(batch.y[q] - record.y_reference),
            .origin = record.depth.origin,
            .dx = record.depth.dx,
            .dy = record.depth.dy,
            .depth_min = record.depth_min,
            .depth_max = record.depth_max};
}

} // namespace

void cover_tile(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    FastStages.cover_tile(edges, tile, coverage);
    take_coverage(edges, tile, tile, coverage);
}

void cover_windows(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
    FastStages.cover_windows(edges, tile, coverage);
    const Rectangle area = intersect(edges.box, tile);
    if (area.empty()) return;
    const auto end = [](int from, int to) {
        return from + (to - from + BlockSize - 1) / BlockSize * BlockSize;
    };
    const int x = area.x0 & ~1, y = area.y0 & ~1;
    take_coverage(edges, tile, {x, y, end(x, area.x1), end(y, area.y1)}, coverage);
}

void cover_tile_samples(const SetupRecord& record,
                        const Rectangle& tile,
                        TileSampleCoverage& coverage) {
    FastStages.cover_tile_samples(record, tile, coverage);
    std::uint64_t fragments = 0;
    for (unsigned i = 0; i < coverage.count; ++i)
        fragments += static_cast<std::uint64_t>(std::popcount(coverage.blocks[i].any()));
    loop_log().count(TileWalkerUnit::Name, "multisampling", fragments);
}

BlockMask smooth_block(const SetupRecord& record, int x, int y, BlockAntialias& antialias) {
    const BlockMask mask = FastStages.smooth_block(record, x, y, antialias);
    loop_log().count(
        TileWalkerUnit::Name, "smooth primitives", static_cast<std::uint64_t>(std::popcount(mask)));
    return mask;
}

void interpolate_depth(BatchRuns runs, FragmentBatch& batch) {
    FastStages.interpolate_depth(runs, batch);
    std::vector<DepthPlaneQuad> quads;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const unsigned end = i + 1 < runs.size() ? runs[i + 1].first_quad : batch.quad_count;
        for (unsigned q = runs[i].first_quad; q < end; ++q)
            quads.push_back(plane_quad(*runs[i].record, batch, q));
    }
    const auto outputs = unit<DepthPlaneUnit>().run({}, quads);
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        const std::uint32_t got = outputs[lane / 4].depths[lane % 4];
        if (batch.live.test(lane))
            compare_lane(
                at_lane(DepthPlaneUnit::Name, batch, lane), "depth", batch.depth[lane], got);
        batch.depth[lane] = got;
    }
    loop_log().count(DepthPlaneUnit::Name, "", batch.live.count());
}

void interpolate_sample_depths(BatchRuns runs, const FragmentBatch& batch, SampleDepths& depths) {
    FastStages.interpolate_sample_depths(runs, batch, depths);
    loop_log().count(DepthPlaneUnit::Name, "multisampling", batch.live.count());
}

} // namespace ffgpu::rtl
