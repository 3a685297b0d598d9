// Traversal orders against their definitions: permutations of the same quads, Morton's by the bits
// of coordinates, Hilbert's against a construction of its own, and which blocks a walk visits.

#include "model/work/block_walk.h"
#include "model/work/traversal.h"
#include "model/work/traversal_keys.h"

#include <cstdlib>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

class Random {
public:
    explicit Random(std::uint32_t seed)
        : generator_(seed) {}
    std::uint32_t operator()() { return static_cast<std::uint32_t>(generator_()); }

private:
    std::mt19937 generator_;
};

constexpr Traversal Orders[] = {Traversal::Scanline,
                                Traversal::Column,
                                Traversal::Tiled,
                                Traversal::Nested,
                                Traversal::Morton,
                                Traversal::Hilbert};

RasterOrder order_of(Traversal traversal, std::uint32_t tile = 8, std::uint32_t outer = 32) {
    RasterOrder raster;
    raster.traversal = traversal;
    raster.tile_width = tile;
    raster.outer_tile_width = outer;
    return raster;
}

// Places (column, row) in the order of their keys.
using Places = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
Places walked(const RasterOrder& raster, std::uint32_t size) {
    std::vector<std::pair<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>>> keyed;
    for (std::uint32_t row = 0; row < size; ++row)
        for (std::uint32_t column = 0; column < size; ++column)
            keyed.push_back({traversal_key(raster, 2 * column, 2 * row), {column, row}});
    std::sort(keyed.begin(), keyed.end());
    Places places;
    for (const auto& [key, place] : keyed)
        places.push_back(place);
    return places;
}

TEST_CASE("every order gives each quad of the largest surface a key of its own below 2^24") {
    for (const Traversal traversal : Orders) {
        const RasterOrder raster = order_of(traversal);
        std::vector<bool> seen(std::size_t{1} << 24);
        std::size_t keys = 0;
        for (std::uint32_t y = 0; y < 4096; y += 2)
            for (std::uint32_t x = 0; x < 4096; x += 2) {
                const std::uint32_t key = traversal_key(raster, x, y);
                if (key >= seen.size() || seen[key]) continue;
                seen[key] = true;
                ++keys;
            }
        INFO(TraversalNames[static_cast<std::size_t>(traversal)]);
        CHECK(keys == 2048 * 2048);
    }
}

TEST_CASE("tables of keys tell those of every order") {
    Random random(9);
    for (const Traversal traversal : Orders)
        for (const std::uint32_t tile : {2u, 8u, 64u}) {
            const RasterOrder raster = order_of(traversal, tile, 64);
            const TraversalKeys keys(raster);
            for (int i = 0; i < 2000; ++i) {
                const std::uint32_t x = random() % (2u << QuadBits);
                const std::uint32_t y = random() % (2u << QuadBits);
                REQUIRE(keys(x, y) == traversal_key(raster, x, y));
            }
        }
}

TEST_CASE("Morton's order has the bits of row and column in turn") {
    const RasterOrder raster = order_of(Traversal::Morton);
    Random random(5);
    for (int i = 0; i < 10000; ++i) {
        const std::uint32_t x = random() % 4096, y = random() % 4096;
        std::uint32_t expected = 0, place = 1;
        for (std::uint32_t column = x / 2, row = y / 2; column + row > 0; column /= 2, row /= 2) {
            expected += place * (column % 2) + 2 * place * (row % 2);
            place *= 4;
        }
        REQUIRE(traversal_key(raster, x, y) == expected);
    }
}

// Hilbert's curve as he drew it: four copies of the smaller one, the first and the last turned.
Places hilbert(unsigned order) {
    if (order == 0) return {{0, 0}};
    const Places smaller = hilbert(order - 1);
    const std::uint32_t half = 1u << (order - 1), last = half - 1;
    Places curve;
    for (const auto& [x, y] : smaller)
        curve.push_back({y, x});
    for (const auto& [x, y] : smaller)
        curve.push_back({x, y + half});
    for (const auto& [x, y] : smaller)
        curve.push_back({x + half, y + half});
    for (const auto& [x, y] : smaller)
        curve.push_back({last - y + half, last - x});
    return curve;
}

TEST_CASE("Hilbert's order is the recursive construction") {
    constexpr unsigned Order = 8; // with 12 levels: an even number fewer
    const Places curve = hilbert(Order);
    CHECK(walked(order_of(Traversal::Hilbert), 1u << Order) == curve);
}

TEST_CASE("along Hilbert's curve each quad lies beside the one before") {
    const Places places = walked(order_of(Traversal::Hilbert), 512);
    for (std::size_t i = 1; i < places.size(); ++i) {
        const auto [x, y] = places[i];
        const auto [a, b] = places[i - 1];
        REQUIRE(std::abs(int(x) - int(a)) + std::abs(int(y) - int(b)) == 1);
    }
}

TEST_CASE("fragments in their order go through the blocks as quads do, none twice") {
    for (const Traversal traversal : Orders) {
        const RasterOrder raster = order_of(traversal, 4, 16);
        std::vector<std::pair<std::uint64_t, std::uint32_t>> order; // of fragments: key, block
        for (std::uint32_t y = 40; y < 104; ++y)
            for (std::uint32_t x = 72; x < 136; ++x)
                order.emplace_back(fragment_traversal_key(raster, x, y),
                                   traversal_block(raster, x, y));
        std::sort(order.begin(), order.end());
        INFO(TraversalNames[static_cast<std::size_t>(traversal)]);
        for (std::size_t i = 1; i < order.size(); ++i) {
            REQUIRE(order[i - 1].first < order[i].first);
            REQUIRE(order[i - 1].second <= order[i].second);
        }
    }
}

TEST_CASE("nested tiles: row by row at three levels") {
    const Places places = walked(order_of(Traversal::Nested, 4, 16), 16);
    Places expected;
    for (std::uint32_t outer = 0; outer < 4; ++outer)
        for (std::uint32_t tile = 0; tile < 16; ++tile)
            for (std::uint32_t quad = 0; quad < 4; ++quad)
                expected.push_back({outer % 2 * 8 + tile % 4 * 2 + quad % 2,
                                    outer / 2 * 8 + tile / 4 * 2 + quad / 2});
    CHECK(places == expected);
}

// The blocks of a box one by one, sorted by the keys of their first quads.
std::vector<std::uint32_t> blocks_of(const RasterOrder& raster, const PieceBox& box) {
    std::set<std::uint32_t> blocks;
    for (std::uint32_t y = box.y0; y < box.y1; ++y)
        for (std::uint32_t x = box.x0; x < box.x1; ++x)
            blocks.insert(traversal_block(raster, x, y));
    return {blocks.begin(), blocks.end()};
}

TEST_CASE("a walk visits each block that the box touches once, in the order of the traversal") {
    Random random(6);
    for (int i = 0; i < 600; ++i) {
        const RasterOrder raster = order_of(Orders[i % 6], 2u << random() % 5, 2u << random() % 7);
        const auto at = [&](unsigned most) { return static_cast<std::uint16_t>(random() % most); };
        PieceBox box{at(600), at(600), 0, 0};
        box.x1 = static_cast<std::uint16_t>(box.x0 + 1 + at(120));
        box.y1 = static_cast<std::uint16_t>(box.y0 + 1 + at(120));
        const BlockWalk walk(raster, box);
        const auto blocks = blocks_of(raster, box);
        INFO("order " << i % 6 << ", tile " << raster.tile_width << ", outer "
                      << raster.outer_tile_width);
        REQUIRE(walk.blocks() == blocks.size());
        for (int k = 0; k < 20; ++k) {
            const std::uint32_t x = box.x0 + random() % (box.x1 - box.x0);
            const std::uint32_t y = box.y0 + random() % (box.y1 - box.y0);
            const auto found =
                std::lower_bound(blocks.begin(), blocks.end(), traversal_block(raster, x, y));
            REQUIRE(walk.before(x, y) == static_cast<std::uint32_t>(found - blocks.begin()));
        }
    }
    CHECK(BlockWalk(order_of(Traversal::Tiled), {}).blocks() == 0);
}

} // namespace
} // namespace ffgpu::work
