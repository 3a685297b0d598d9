// The tables of the texture-cache literature: miss rates of analytic scenes over cache size, line,
// block, associativity, layout and order (the experiments of Z. Hakura and A. Gupta, The Design and
// Analysis of a Cache Architecture for Texture Mapping, ISCA 1997, and of J. McCormack and
// R. McNamara, Tiled Polygon Traversal Using Half-Plane Edge Functions, 2000). The expected figures
// come from an independent model that looks each texel up, fragment after fragment, in a cache with
// LRU replacement; so does the machine whose granularity is a fragment. The figures of one that
// works in quads stand beside them in docs/units/texel_cache.md.

#include "tests/work/texel_streams.h"

#include <array>
#include <iostream>
#include <string>

#include <catch2/catch.hpp>

namespace ffgpu::work {
namespace {

constexpr double Margin = 0.05; // points

struct Order {
    Traversal traversal = Traversal::Tiled;
    std::uint32_t tile = 8;
};
constexpr Order Scan{Traversal::Scanline, 8}, Column{Traversal::Column, 8}, Tiles8{};

struct Placing {
    Layout layout = Layout::Blocked;
    std::uint32_t block = 4;
};
constexpr Placing Linear{Layout::Linear, 4}, Blocks4{}, SixD{Layout::Blocked6d, 4};

WorkConfig
machine(Order order, Placing placing, Granularity granularity, std::uint32_t line_bytes = 64) {
    WorkConfig config;
    config.raster.granularity = granularity;
    config.raster.traversal = order.traversal;
    config.raster.tile_width = order.tile;
    config.texel_cache.layout = placing.layout;
    config.texel_cache.block_width = placing.block;
    config.texel_cache.line_bytes = line_bytes;
    return config;
}

// A scene whose work is made once and read by many machines.
struct Scenes {
    std::shared_ptr<const WorkBin> flat = bin_of(timing::turned_scene(512, 0));
    std::shared_ptr<const WorkBin> turned = bin_of(timing::turned_scene(512, 30));
    std::shared_ptr<const WorkBin> floor_256 = bin_of(timing::floor_scene(256));
    std::shared_ptr<const WorkBin> floor_1024 = bin_of(timing::floor_scene(1024));
};
const Scenes& scenes() {
    static const Scenes all;
    return all;
}

// Prints a row as the page has it, and holds the fragment machine to the expected figures.
class Table {
public:
    explicit Table(const std::string& title) { std::cout << "\n| " << title << " |\n"; }

    void row(const std::string& name,
             const std::vector<double>& expected,
             const std::vector<double>& fragments,
             const std::vector<double>& quads) {
        std::string text = "| " + name;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            INFO(name << ", column " << i);
            CHECK(fragments[i] == Approx(expected[i]).margin(Margin));
            char cell[64];
            std::snprintf(cell, sizeof cell, " | %.2f / %.2f", fragments[i], quads[i]);
            text += cell;
        }
        std::cout << text << " |\n";
    }
};

template <class Rate>
std::vector<double> rates(std::size_t count, Rate&& rate) {
    std::vector<double> all;
    for (std::size_t i = 0; i < count; ++i)
        all.push_back(rate(i));
    return all;
}

TEST_CASE("E1: miss rates by cache size, fully associative, lines of 64 bytes", "[tables]") {
    struct Row {
        const char* name;
        std::shared_ptr<const WorkBin> bin;
        Placing placing;
        Order order;
        std::vector<double> expected; // 1 to 64 KB
    };
    const Scenes& all = scenes();
    const Row rows[] = {
        {"flat, linear, scan lines",
         all.flat,
         Linear,
         Scan,
         {3.17, 3.17, 1.57, 1.57, 1.57, 1.57, 1.57}},
        {"flat, linear, columns",
         all.flat,
         Linear,
         Column,
         {26.57, 26.57, 26.57, 26.57, 26.57, 4.69, 1.61}},
        {"flat, 4x4, scan lines",
         all.flat,
         Blocks4,
         Scan,
         {7.83, 7.83, 7.83, 4.68, 1.58, 1.58, 1.58}},
        {"flat, 4x4, columns",
         all.flat,
         Blocks4,
         Column,
         {7.83, 7.83, 7.83, 4.69, 1.58, 1.58, 1.58}},
        {"flat, 4x4, 8x8 tiles",
         all.flat,
         Blocks4,
         Tiles8,
         {2.36, 2.36, 2.36, 2.36, 2.36, 1.58, 1.58}},
        {"turned by 30, linear, scan lines",
         all.turned,
         Linear,
         Scan,
         {15.38, 15.38, 15.38, 15.38, 15.38, 1.64, 1.64}},
        {"turned by 30, 4x4, scan lines",
         all.turned,
         Blocks4,
         Scan,
         {10.06, 10.06, 10.06, 10.06, 1.60, 1.60, 1.60}},
        {"turned by 30, 4x4, 8x8 tiles",
         all.turned,
         Blocks4,
         Tiles8,
         {2.64, 2.64, 2.64, 2.64, 2.64, 1.60, 1.60}},
        {"floor 256, linear, scan lines",
         all.floor_256,
         Linear,
         Scan,
         {4.87, 4.77, 4.63, 4.38, 3.87, 0.57, 0.52}},
        {"floor 256, linear, columns",
         all.floor_256,
         Linear,
         Column,
         {20.93, 20.06, 18.94, 18.04, 17.34, 3.63, 0.58}},
        {"floor 256, 4x4, scan lines",
         all.floor_256,
         Blocks4,
         Scan,
         {3.78, 3.69, 3.55, 3.39, 2.33, 0.55, 0.51}},
        {"floor 256, 4x4, 8x8 tiles",
         all.floor_256,
         Blocks4,
         Tiles8,
         {1.28, 1.06, 1.03, 0.98, 0.85, 0.74, 0.50}},
        {"floor 1024, linear, columns",
         all.floor_1024,
         Linear,
         Column,
         {23.38, 23.14, 22.88, 22.74, 22.74, 19.38, 0.84}},
        {"floor 1024, 4x4, 8x8 tiles",
         all.floor_1024,
         Blocks4,
         Tiles8,
         {1.31, 1.10, 1.10, 1.09, 1.07, 0.95, 0.69}},
    };
    Table table("E1 | 1 KB | 2 KB | 4 KB | 8 KB | 16 KB | 32 KB | 64 KB");
    for (const Row& row : rows) {
        const auto of = [&](Granularity granularity) {
            const TexelStream stream =
                texel_stream(row.bin, machine(row.order, row.placing, granularity));
            return rates(7, [&](std::size_t i) { return stream.miss_percent(1, 16u << i); });
        };
        table.row(row.name, row.expected, of(Granularity::Fragment), of(Granularity::Quad));
    }
}

TEST_CASE("E2: miss rates by line and block, floor 256, 16 KB fully associative", "[tables]") {
    struct Row {
        const char* name;
        Order order;
        std::uint32_t line_bytes;
        std::vector<double> expected; // blocks of 1 (linear), 2, 4, 8, 16
    };
    const Row rows[] = {
        {"scan lines, 32", Scan, 32, {2.83, 1.36, 1.36, 2.83, 2.83}},
        {"scan lines, 64", Scan, 64, {3.87, 2.11, 2.33, 2.11, 3.87}},
        {"scan lines, 128", Scan, 128, {3.58, 2.17, 1.86, 1.86, 2.17}},
        {"scan lines, 256", Scan, 256, {3.30, 1.91, 1.31, 1.38, 1.31}},
        {"8x8 tiles, 32", Tiles8, 32, {1.56, 1.49, 1.49, 1.56, 1.56}},
        {"8x8 tiles, 64", Tiles8, 64, {0.97, 0.83, 0.85, 0.83, 0.97}},
        {"8x8 tiles, 128", Tiles8, 128, {0.74, 0.52, 0.47, 0.47, 0.52}},
        {"8x8 tiles, 256", Tiles8, 256, {0.56, 0.39, 0.30, 0.31, 0.30}},
    };
    Table table("E2 | linear | 2x2 | 4x4 | 8x8 | 16x16");
    for (const Row& row : rows) {
        const auto of = [&](Granularity granularity) {
            return rates(5, [&](std::size_t i) {
                const Placing placing{i == 0 ? Layout::Linear : Layout::Blocked, 1u << i};
                return texel_stream(scenes().floor_256,
                                    machine(row.order, placing, granularity, row.line_bytes))
                    .miss_percent(1, (16u << 10) / row.line_bytes);
            });
        };
        table.row(row.name, row.expected, of(Granularity::Fragment), of(Granularity::Quad));
    }
}

TEST_CASE("E3: miss rates by associativity and layout, floor 1024, 8x8 tiles", "[tables]") {
    struct Row {
        const char* name;
        Placing placing;
        std::uint32_t lines;
        std::vector<double> expected; // direct mapped, 2, 4 ways, fully associative
    };
    const Row rows[] = {
        {"4x4, 8 KB", Blocks4, 128, {7.85, 2.08, 1.23, 1.09}},
        {"6-D, 8 KB", SixD, 128, {1.61, 1.09, 1.09, 1.09}},
        {"4x4, 16 KB", Blocks4, 256, {3.78, 1.75, 1.16, 1.07}},
        {"6-D, 16 KB", SixD, 256, {1.34, 1.07, 1.06, 1.07}},
        {"4x4, 32 KB", Blocks4, 512, {1.32, 1.25, 1.03, 0.95}},
        {"6-D, 32 KB", SixD, 512, {1.02, 0.95, 0.98, 0.95}},
    };
    Table table("E3 | direct mapped | 2 ways | 4 ways | fully associative");
    for (const Row& row : rows) {
        const auto of = [&](Granularity granularity) {
            const TexelStream stream =
                texel_stream(scenes().floor_1024, machine(Tiles8, row.placing, granularity));
            return rates(4, [&](std::size_t i) {
                const std::uint32_t ways = i == 3 ? row.lines : 1u << i;
                return stream.miss_percent(row.lines / ways, ways);
            });
        };
        table.row(row.name, row.expected, of(Granularity::Fragment), of(Granularity::Quad));
    }
}

TEST_CASE("E4: miss rates by raster tile, floor 256, fully associative", "[tables]") {
    struct Row {
        const char* name;
        Order order;
        std::vector<double> expected; // 2, 4, 8, 16 KB
    };
    const Row rows[] = {
        {"scan lines", Scan, {3.69, 3.55, 3.39, 2.33}},
        {"tiles of 4", {Traversal::Tiled, 4}, {1.43, 1.39, 1.31, 1.19}},
        {"tiles of 8", {Traversal::Tiled, 8}, {1.06, 1.03, 0.98, 0.85}},
        {"tiles of 16", {Traversal::Tiled, 16}, {1.13, 0.85, 0.81, 0.75}},
        {"tiles of 32", {Traversal::Tiled, 32}, {1.00, 0.96, 0.77, 0.68}},
        {"tiles of 64", {Traversal::Tiled, 64}, {2.11, 0.81, 0.77, 0.72}},
    };
    Table table("E4 | 2 KB | 4 KB | 8 KB | 16 KB");
    for (const Row& row : rows) {
        const auto of = [&](Granularity granularity) {
            const TexelStream stream =
                texel_stream(scenes().floor_256, machine(row.order, Blocks4, granularity));
            return rates(4, [&](std::size_t i) { return stream.miss_percent(1, 32u << i); });
        };
        table.row(row.name, row.expected, of(Granularity::Fragment), of(Granularity::Quad));
    }
}

} // namespace
} // namespace ffgpu::work
