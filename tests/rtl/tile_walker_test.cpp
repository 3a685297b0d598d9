// rtl/tile_walker.sv against cover_tile_scalar().

#include "Vtile_walker.h"
#include "model/raster/coverage.h"
#include "rtl/bundles/tile.h"
#include "tests/rtl/bench/unit_bench.h"

#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

namespace ffgpu::rtl {
namespace {

struct TileWalker {
    static constexpr const char* Name = "tile_walker";
    static constexpr bool TakesEachCycle = false;
    static constexpr std::uint64_t ShortItems = 20000, LongItems = 500000; // some 50 cycles each

    using Dut = Vtile_walker;
    using State = NoState;
    using Input = TileEdges;
    using Output = CoveredQuad;

    static void set_tag(TileEdges& walk, unsigned tag) { walk.tag = tag != 0; }
    static State random_state(Random&) { return {}; }

    // A coordinate in or around the tile, or far off, up to the ends of what there is; on a pixel's
    // centre often, so that edges meet centres.
    static std::int32_t coordinate(Random& random, int tile) {
        const int reach = !random.one_in(6) ? 48 : random.one_in(3) ? 24576 : 2000;
        const int whole =
            tile - reach / 3 + static_cast<int>(random.below(static_cast<std::uint32_t>(reach)));
        const int clamped = std::clamp(whole, -8191, 8191);
        return 256 * clamped + (random.one_in(2) ? 128 : static_cast<int>(random.below(256)));
    }
    // Up to four corners, counter-clockwise where there are three.
    static void random_edges(Random& random, TileEdges& walk) {
        std::array<SubPixelPoint, MaxEdges> corners;
        for (SubPixelPoint& corner : corners)
            corner = {coordinate(random, walk.tile_x), coordinate(random, walk.tile_y)};
        if (double_area(corners[0], corners[1], corners[2]) < 0) std::swap(corners[1], corners[2]);
        walk.edge_count = static_cast<std::uint8_t>(random.one_in(4) ? random.below(5) : 3);
        for (unsigned i = 0; i < MaxEdges; ++i) {
            const unsigned count = std::max<unsigned>(walk.edge_count, 1);
            const Edge edge = make_edge(corners[i], corners[(i + 1) % count]);
            walk.a[i] = edge.a;
            walk.b[i] = edge.b;
            walk.c[i] = edge.c;
        }
    }
    static TileEdges random_input(Random& random, const State&) {
        TileEdges walk{.draw = random.word(),
                       .primitive = random.word(),
                       .piece = random.word(),
                       .front_facing = random.one_in(2),
                       .tile_x = static_cast<std::uint16_t>(random.below(256) * TileSize),
                       .tile_y = static_cast<std::uint16_t>(random.below(256) * TileSize)};
        const auto bound = [&](int tile) {
            const int at = tile - 8 + static_cast<int>(random.below(48));
            return static_cast<std::uint16_t>(std::clamp(at, 0, 8192));
        };
        walk.box_x1 = walk.box_y1 = 8192;
        if (random.one_in(2)) walk.box_x0 = bound(walk.tile_x);
        if (random.one_in(2)) walk.box_y0 = bound(walk.tile_y);
        if (random.one_in(2)) walk.box_x1 = bound(walk.tile_x);
        if (random.one_in(2)) walk.box_y1 = bound(walk.tile_y);
        random_edges(random, walk);
        return walk;
    }

    static void cover_tile(const TileEdges& walk, TileCoverage& coverage) {
        std::array<Edge, MaxEdges> edges;
        for (unsigned i = 0; i < MaxEdges; ++i)
            edges[i] = {walk.a[i], walk.b[i], walk.c[i]};
        const Rectangle box{walk.box_x0, walk.box_y0, walk.box_x1, walk.box_y1};
        const Rectangle tile{
            walk.tile_x, walk.tile_y, walk.tile_x + TileSize, walk.tile_y + TileSize};
        cover_tile_scalar({box, {edges.data(), walk.edge_count}}, tile, coverage);
    }

    static void declare(Bins& bins) {
        bins.declare("edges", 5);
        bins.declare("live lanes", 16);
        bins.hit("live lanes", 0); // No quad has none.
        bins.declare("blocks: none, some, all", 3);
        bins.declare("block partly, wholly covered", 2);
        bins.declare("centre on an edge", 1);
    }
    static void cover(Bins& bins, const State&, const TileEdges& walk) {
        TileCoverage coverage;
        cover_tile(walk, coverage);
        bins.hit("edges", walk.edge_count);
        bins.hit("blocks: none, some, all", coverage.count == 0 ? 0 : coverage.count < 16 ? 1 : 2);
        for (unsigned i = 0; i < coverage.count; ++i) {
            bins.hit("block partly, wholly covered", coverage.blocks[i].mask == FullBlock);
            for (unsigned quad = 0; quad < 16; ++quad)
                if (const unsigned live = coverage.blocks[i].mask >> 4 * quad & 15)
                    bins.hit("live lanes", live);
        }
        for (unsigned i = 0; i < walk.edge_count; ++i)
            for (int x = walk.tile_x; x < walk.tile_x + TileSize; ++x)
                if (Edge{walk.a[i], walk.b[i], walk.c[i]}.at(x, walk.tile_y + 7) == 0)
                    bins.hit("centre on an edge", 0);
    }

    static void expect(const State&, const TileEdges& walk, std::vector<CoveredQuad>& outputs) {
        TileCoverage coverage;
        cover_tile(walk, coverage);
        for (unsigned i = 0; i < coverage.count; ++i)
            for (unsigned quad = 0; quad < 16; ++quad) {
                const BlockCoverage& block = coverage.blocks[i];
                const auto live = static_cast<std::uint8_t>(block.mask >> 4 * quad & 15);
                if (live != 0)
                    outputs.push_back({walk.tag,
                                       walk.draw,
                                       walk.primitive,
                                       walk.piece,
                                       walk.front_facing,
                                       static_cast<std::uint16_t>(block.x + quad % 4 * 2),
                                       static_cast<std::uint16_t>(block.y + quad / 4 * 2),
                                       live});
            }
    }
};
using Unit = TileWalker;

} // namespace
} // namespace ffgpu::rtl

#include "tests/rtl/bench/unit_tests.inl"

namespace ffgpu::rtl {
namespace {

// Blocks that the box overlaps and in which each edge by itself has a pixel.
unsigned touched_blocks(const TileEdges& walk) {
    std::array<TileCoverage, MaxEdges> sides;
    for (unsigned i = 0; i < walk.edge_count; ++i) {
        TileEdges side = walk;
        side.box_x0 = side.box_y0 = 0;
        side.box_x1 = side.box_y1 = 8192;
        side.edge_count = 1;
        side.a[0] = walk.a[i];
        side.b[0] = walk.b[i];
        side.c[0] = walk.c[i];
        TileWalker::cover_tile(side, sides[i]);
    }
    unsigned count = 0;
    for (int y = walk.tile_y; y < walk.tile_y + TileSize; y += 8)
        for (int x = walk.tile_x; x < walk.tile_x + TileSize; x += 8) {
            bool touched =
                x < walk.box_x1 && y < walk.box_y1 && x + 8 > walk.box_x0 && y + 8 > walk.box_y0;
            for (unsigned i = 0; i < walk.edge_count; ++i)
                touched &= std::any_of(
                    sides[i].blocks.begin(),
                    sides[i].blocks.begin() + sides[i].count,
                    [&](const BlockCoverage& block) { return block.x == x && block.y == y; });
            count += touched;
        }
    return count;
}

TEST_CASE("a tile takes a cycle, one a block, and sixteen more one that edges and box touch") {
    VerilatedContext context;
    Vtile_walker dut(&context);
    const auto cycle = [&] {
        dut.clk_i = 1;
        dut.eval();
        dut.clk_i = 0;
        dut.eval();
    };
    dut.in_valid_i = dut.clk_i = 0;
    dut.out_ready_i = 1;
    for (const int reset : {1, 0, 1}) {
        dut.rst_ni = static_cast<std::uint8_t>(reset);
        dut.eval();
    }
    Random random(11);
    std::set<unsigned> seen;
    for (unsigned i = 0; i < 2000; ++i) {
        const TileEdges walk = TileWalker::random_input(random, {});
        drive(dut.in_data_i, to_bits(walk));
        dut.in_valid_i = 1;
        dut.eval();
        REQUIRE(dut.in_ready_o);
        cycle();
        dut.in_valid_i = 0;
        dut.eval();
        unsigned cycles = 1;
        for (; !dut.in_ready_o && cycles < 1000; ++cycles)
            cycle();
        const unsigned touched = touched_blocks(walk);
        INFO(i << ": " << touched << " blocks are touched");
        REQUIRE(cycles == 1 + 16 + 16 * touched);
        seen.insert(touched);
    }
    CHECK(seen.size() > 10);
}

} // namespace
} // namespace ffgpu::rtl
