// The rasterizer's walk against a count of its own: a block with quads takes the walk tile_cycles,
// an empty one of the box empty_tile_cycles, a piece without quads a cycle at least; the quads of
// what was walked to are made beside it.

#include "tests/support/drawn_quad.h"
#include "tests/timing/front_end_scenes.h"

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::timing {
namespace {

using Place = std::pair<std::uint32_t, std::uint32_t>; // of a quad: column, row

struct Piece {
    PieceBox box;
    std::set<Place> quads;
};

std::vector<Piece> random_pieces(std::uint32_t seed, unsigned count) {
    std::mt19937 random(seed);
    const auto below = [&](int limit) {
        return static_cast<std::uint16_t>(random() % static_cast<unsigned>(limit));
    };
    std::vector<Piece> pieces;
    for (unsigned i = 0; i < count; ++i) {
        Piece& piece = pieces.emplace_back();
        if (i % 7 == 6) continue; // It covers nothing that a rasterizer could walk.
        PieceBox& box = piece.box;
        box = {below(300), below(300), 0, 0};
        box.x1 = static_cast<std::uint16_t>(box.x0 + 1 + below(90));
        box.y1 = static_cast<std::uint16_t>(box.y0 + 1 + below(90));
        const unsigned quads = i % 3 == 0 ? 0 : below(60);
        for (unsigned q = 0; q < quads; ++q)
            piece.quads.insert(
                {(box.x0 + below(box.x1 - box.x0)) / 2u, (box.y0 + below(box.y1 - box.y0)) / 2u});
    }
    return pieces;
}

// All pieces, `times` over, of one primitive of one vertex.
WorkBin draw_of(const std::vector<Piece>& pieces, unsigned times) {
    WorkBin bin;
    WorkDraw& draw = bin.draws.emplace_back();
    draw.state = std::make_shared<Registers>();
    draw.geometry.vertex_bytes = 16;
    draw.geometry.vertices = {0};
    WorkBatch& batch = bin.tiles.emplace_back().batches.emplace_back();
    batch.draw = 0;
    for (unsigned time = 0; time < times; ++time)
        for (const Piece& piece : pieces) {
            for (const auto& [column, row] : piece.quads) {
                WorkQuad quad = drawn_quad(2 * column, 2 * row);
                quad.piece = static_cast<std::uint32_t>(draw.geometry.pieces.size());
                batch.quads.push_back(quad);
            }
            draw.geometry.pieces.push_back(piece.box);
        }
    draw.geometry.primitives = {
        {.pieces = static_cast<std::uint32_t>(draw.geometry.pieces.size())}};
    return bin;
}

// Cells of cell_width x cell_height pixels of the box, and the quads in each.
std::uint64_t expected_cycles(const Piece& piece, const RasterConfig& config) {
    std::uint32_t width = config.tile_width, height = config.tile_width;
    if (config.traversal == Traversal::Scanline) width = 1 << 20, height = 2;
    if (config.traversal == Traversal::Column) width = 2, height = 1 << 20;
    std::map<Place, std::uint32_t> cells;
    for (std::uint32_t y = piece.box.y0; y < piece.box.y1; ++y)
        for (std::uint32_t x = piece.box.x0; x < piece.box.x1; ++x)
            cells[{x / width, y / height}] = 0;
    for (const auto& [column, row] : piece.quads)
        ++cells[{2 * column / width, 2 * row / height}];
    const std::uint32_t n = config.quads_per_cycle;
    std::uint64_t cycles = 0;
    for (const auto& [cell, quads] : cells)
        cycles += quads == 0 ? config.empty_tile_cycles : config.tile_cycles + (quads + n - 1) / n;
    return std::max<std::uint64_t>(cycles, 1);
}

// The cycle in which the last of all pieces is over, `times` over, by the rules of the queue
// between the walk and the making of quads. Blocks in the order of their rows.
class WalkedAhead {
public:
    explicit WalkedAhead(const RasterConfig& config)
        : config_(config) {}

    void add(const Piece& piece) {
        std::map<Place, std::uint32_t> cells; // row, column
        const std::uint32_t width = config_.tile_width;
        for (std::uint32_t y = piece.box.y0; y < piece.box.y1; ++y)
            for (std::uint32_t x = piece.box.x0; x < piece.box.x1; ++x)
                cells[{y / width, x / width}] = 0;
        for (const auto& [column, row] : piece.quads)
            ++cells[{2 * row / width, 2 * column / width}];
        made_in_cycle_ = config_.quads_per_cycle; // A piece's quads begin in a cycle of their own.
        std::uint64_t empty = 0;
        for (const auto& [cell, quads] : cells) {
            if (quads == 0) {
                ++empty;
                continue;
            }
            begin(empty * config_.empty_tile_cycles + config_.tile_cycles);
            empty = 0;
            make(quads);
        }
        std::uint64_t behind = empty * config_.empty_tile_cycles;
        if (piece.quads.empty()) behind = std::max<std::uint64_t>(behind, 1);
        if (behind == 0) return;
        begin(behind);
        gone_.push_back(std::max(walked_at_ - 1, gone_.empty() ? 0 : gone_.back()));
    }
    std::uint64_t end() const { return gone_.back(); }

private:
    void begin(std::uint64_t cycles) {
        const std::size_t before = gone_.size();
        const std::uint64_t place =
            before < config_.block_queue ? 0 : gone_[before - config_.block_queue] + 1;
        walked_at_ = std::max(walked_at_, place) + cycles;
    }
    void make(std::uint32_t quads) {
        for (std::uint32_t quad = 0; quad < quads; ++quad) {
            if (made_in_cycle_ == config_.quads_per_cycle) {
                ++cycle_;
                made_in_cycle_ = 0;
            }
            if (cycle_ < walked_at_) {
                cycle_ = walked_at_;
                made_in_cycle_ = 0;
            }
            ++made_in_cycle_;
        }
        gone_.push_back(cycle_);
    }

    const RasterConfig config_;
    std::uint64_t walked_at_ = 1; // the first cycle after the walk's steps
    std::uint64_t cycle_ = 0;     // in which quads were made last, and how many
    std::uint32_t made_in_cycle_ = 0;
    std::vector<std::uint64_t> gone_; // of each block
};

TEST_CASE("a piece takes the cycles of the blocks of its box and of its quads, in every order") {
    const std::vector<Piece> pieces = random_pieces(1, 60);
    for (unsigned i = 0; i < work::TraversalNames.size() * 6; ++i) {
        TimingConfig config = wide_front_end();
        config.raster.block_queue = 1;
        config.raster.traversal = static_cast<Traversal>(i % work::TraversalNames.size());
        config.raster.tile_width = i % 4 < 2 ? 8 : 4;
        config.raster.quads_per_cycle = i % 3 == 0 ? 1 : i % 3 == 1 ? 4 : 3;
        config.raster.tile_cycles = 1 + i % 2 * 2;
        config.raster.empty_tile_cycles = i % 5 == 0 ? 0 : i % 5;
        std::uint64_t expected = 0;
        for (const Piece& piece : pieces)
            expected += expected_cycles(piece, config.raster);
        INFO("order " << i % 6 << ", " << config.raster.quads_per_cycle << " quads, empty "
                      << config.raster.empty_tile_cycles << ", tile " << config.raster.tile_cycles);
        const Figures once = run(config, draw_of(pieces, 1));
        const Figures twice = run(config, draw_of(pieces, 2));
        CHECK(twice.at("total_cycles") - once.at("total_cycles") == expected);
        CHECK(run(config, draw_of(pieces, 1), 9) == once);
    }
}

TEST_CASE("the walk is ahead of the quads by the blocks that its queue holds") {
    const std::vector<Piece> pieces = random_pieces(2, 60);
    for (unsigned i = 0; i < 48; ++i) {
        TimingConfig config = wide_front_end();
        config.raster.traversal = Traversal::Tiled;
        config.raster.tile_width = i % 2 == 0 ? 8 : 4;
        config.raster.quads_per_cycle = std::array{1, 2, 3, 16}[i % 4];
        config.raster.tile_cycles = 1 + i % 5;
        config.raster.empty_tile_cycles = i % 3;
        config.raster.block_queue = std::array{1, 2, 3, 7, 16, 64}[i % 6];
        config.fragment.pipe_queue = config.raster.queue = 256;
        INFO("queue " << config.raster.block_queue << ", " << config.raster.quads_per_cycle
                      << " quads, empty " << config.raster.empty_tile_cycles << ", tile "
                      << config.raster.tile_cycles);
        WalkedAhead once(config.raster), twice(config.raster);
        for (const Piece& piece : pieces)
            once.add(piece);
        for (unsigned time = 0; time < 2; ++time)
            for (const Piece& piece : pieces)
                twice.add(piece);
        CHECK(run(config, draw_of(pieces, 2)).at("total_cycles") -
                  run(config, draw_of(pieces, 1)).at("total_cycles") ==
              twice.end() - once.end());
    }
}

TEST_CASE("a long thin triangle is walked through all tiles of its box") {
    // The diagonal of 64 x 64 tiles: 64 with a quad, 4032 empty ones.
    Piece diagonal{{0, 0, 512, 512}, {}};
    for (std::uint32_t i = 0; i < 64; ++i)
        diagonal.quads.insert({4 * i, 4 * i});
    for (const Traversal order : {Traversal::Tiled, Traversal::Morton, Traversal::Hilbert}) {
        TimingConfig config = wide_front_end();
        config.raster.traversal = order;
        const Figures figures = run(config, draw_of({diagonal}, 1));
        CHECK(figures.at("raster_blocks") == 64);
        CHECK(figures.at("raster_empty_blocks") == 64 * 64 - 64);
        // Hilbert's curve goes on after the last quad, while the quads drain.
        if (order == Traversal::Hilbert) continue;
        config.raster.empty_tile_cycles = 0;
        CHECK(figures.at("total_cycles") - run(config, draw_of({diagonal}, 1)).at("total_cycles") ==
              64 * 64 - 64);
    }
}

TEST_CASE("a tile-based machine walks a piece in each bin that it covers, and stays inside") {
    // A bin of 32 pixels has 16 tiles: of the four on the diagonal each has a quad in one of them.
    Piece diagonal{{0, 0, 128, 128}, {}};
    for (std::uint32_t i = 0; i < 4; ++i)
        diagonal.quads.insert({16 * i, 16 * i});
    TimingConfig config = wide_front_end();
    config.raster.architecture = Architecture::TileBased;
    const Figures figures = run(config, draw_of({diagonal}, 1));
    CHECK(figures.at("raster_blocks") == 4);
    CHECK(figures.at("raster_empty_blocks") == 4 * 15);
}

} // namespace
} // namespace ffgpu::timing
