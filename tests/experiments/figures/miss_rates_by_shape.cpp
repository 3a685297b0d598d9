// P2, P3 and P8: misses by line and block, by ways and layout, by the rasterizer's tile.

#include "tests/experiments/figures/all.h"
#include "tests/experiments/figures/miss_machine.h"

#include <algorithm>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

struct LineCase {
    const char* name;
    Order order;
    std::uint32_t line_bytes;
    std::vector<double> misses, bytes; // of blocks of 1 (linear), 2, 4, 8, 16
};
const std::vector<LineCase> LineCases{
    {"scan lines, 32", Scan, 32, {2.83, 1.36, 1.36, 2.83, 2.83}, {7.02, 3.36, 3.36, 7.02, 7.02}},
    {"scan lines, 64",
     Scan,
     64,
     {3.87, 2.11, 2.33, 2.11, 3.87},
     {19.18, 10.44, 11.55, 10.44, 19.18}},
    {"scan lines, 128",
     Scan,
     128,
     {3.58, 2.17, 1.86, 1.86, 2.17},
     {35.54, 21.48, 18.41, 18.41, 21.48}},
    {"scan lines, 256", Scan, 256, {3.30, 1.91, 1.31, 1.38, 1.31}, {65.5, 37.8, 26.0, 27.3, 26.0}},
    {"8x8 tiles, 32", Tiles8, 32, {1.56, 1.49, 1.49, 1.56, 1.56}, {3.88, 3.69, 3.69, 3.88, 3.88}},
    {"8x8 tiles, 64", Tiles8, 64, {0.97, 0.83, 0.85, 0.83, 0.97}, {4.80, 4.13, 4.20, 4.13, 4.80}},
    {"8x8 tiles, 128", Tiles8, 128, {0.74, 0.52, 0.47, 0.47, 0.52}, {7.36, 5.13, 4.68, 4.68, 5.13}},
    {"8x8 tiles, 256",
     Tiles8,
     256,
     {0.56, 0.39, 0.30, 0.31, 0.30},
     {11.14, 7.71, 5.89, 6.08, 5.89}}};

constexpr std::uint32_t CacheBytes = 16 << 10;

// Misses in percent, and bytes a fragment.
struct LineFigures {
    std::vector<double> misses, bytes;
};
LineFigures line_figures(const Work& work, const LineCase& each, work::Granularity granularity) {
    LineFigures figures;
    for (std::uint32_t i = 0; i < 5; ++i) {
        const Placing placing{i == 0 ? work::Layout::Linear : work::Layout::Blocked, 1u << i};
        const MissMachine machine{each.order, placing, granularity, each.line_bytes};
        const TexelStream stream = texel_stream(work, machine.config());
        const double misses = stream.misses(1, CacheBytes / each.line_bytes);
        figures.misses.push_back(100 * misses / static_cast<double>(stream.reads));
        figures.bytes.push_back(misses * each.line_bytes / static_cast<double>(stream.fragments));
    }
    return figures;
}

// What the tables' last digits and the edges may cost in bytes.
constexpr double BytesPart = 0.03;

void add_line_rows(const LineCase& each, Table& misses, Table& bytes) {
    const BothWays& scene = floor_scene(256);
    const LineFigures formula = line_figures(scene.formula, each, work::Granularity::Fragment);
    const LineFigures drawn = line_figures(scene.drawn, each, work::Granularity::Fragment);
    const LineFigures quads = line_figures(scene.drawn, each, work::Granularity::Quad);
    misses.rows.push_back({each.name,
                           each.misses,
                           {within_points("by formula", each.misses, formula.misses, Points),
                            within_part("rasterized", each.misses, drawn.misses, RasterPart),
                            {.how = "rasterized, by quad", .values = quads.misses}}});
    bytes.rows.push_back({each.name,
                          each.bytes,
                          {within_part("by formula", each.bytes, formula.bytes, BytesPart),
                           within_part("rasterized", each.bytes, drawn.bytes, RasterPart)}});
}

} // namespace

Experiment miss_rates_by_line() {
    const std::vector<std::string> columns{
        "order, bytes of a line", "linear", "2x2", "4x4", "8x8", "16x16"};
    Table misses{"Misses, % of the texels read", columns, {}},
        bytes{"Bytes from memory a fragment", columns, {}};
    tools::Plot plot{"The floor of 256 texels, 8x8 tiles", "bytes of a line", "bytes a fragment"};
    for (std::size_t i = 1; i < columns.size(); ++i)
        plot.series.push_back({columns[i], {}});
    bool best = true;
    for (const LineCase& each : LineCases) {
        add_line_rows(each, misses, bytes);
        const std::vector<double>& obtained = misses.rows.back().lines[1].values;
        if (each.order.traversal != work::Traversal::Tiled) continue;
        if (each.line_bytes == 128)
            best = obtained[2] <= *std::min_element(obtained.begin(), obtained.end()) + 0.01;
        for (std::size_t i = 0; i < obtained.size(); ++i)
            plot.series[i].points.emplace_back(each.line_bytes,
                                               bytes.rows.back().lines[1].values[i]);
    }
    return {
        .id = "P2",
        .title = "Miss rates by line and block",
        .source = std::string(IndependentModel) + "the experiment: Hakura and Gupta 1997",
        .method = "The floor of 256 texels, a fully associative cache of 16 KB.",
        .tables = {misses, bytes},
        .claims = {{"blocks of 4x4 are best, or equal to it, with lines of 128 bytes", "", best}},
        .plots = {{"p2_lines", svg(plot)}}};
}

Experiment miss_rates_by_ways() {
    struct Case {
        const char* name;
        Placing placing;
        std::uint32_t lines;
        std::vector<double> expected; // direct mapped, 2, 4 ways, fully associative
    };
    const std::vector<Case> cases{{"4x4, 8 KB", Blocks4, 128, {7.85, 2.08, 1.23, 1.09}},
                                  {"6-D, 8 KB", SixD, 128, {1.61, 1.09, 1.09, 1.09}},
                                  {"4x4, 16 KB", Blocks4, 256, {3.78, 1.75, 1.16, 1.07}},
                                  {"6-D, 16 KB", SixD, 256, {1.34, 1.07, 1.06, 1.07}},
                                  {"4x4, 32 KB", Blocks4, 512, {1.32, 1.25, 1.03, 0.95}},
                                  {"6-D, 32 KB", SixD, 512, {1.02, 0.95, 0.98, 0.95}}};
    Table table{"Misses, % of the texels read",
                {"layout, size", "direct mapped", "2 ways", "4 ways", "fully associative"},
                {}};
    tools::Plot plot{"The floor of 1024 texels, rasterized", "ways", "misses, % of texels", {}};
    plot.counts = true;
    for (const Case& each : cases) {
        table.rows.push_back(miss_row(
            each.name,
            each.expected,
            floor_scene(1024),
            [&](const Work& work, work::Granularity granularity) {
                const TexelStream stream =
                    texel_stream(work, MissMachine{Tiles8, each.placing, granularity}.config());
                std::vector<double> rates;
                for (const std::uint32_t ways : {1u, 2u, 4u, each.lines})
                    rates.push_back(stream.miss_percent(each.lines / ways, ways));
                return rates;
            }));
        tools::PlotSeries& series = plot.series.emplace_back();
        series.name = each.name;
        for (std::size_t i = 0; i < 3; ++i)
            series.points.emplace_back(1u << i, table.rows.back().lines[1].values[i]);
    }
    const double blocked = table.rows[0].lines[1].values[0],
                 six_d = table.rows[1].lines[1].values[0];
    return {.id = "P3",
            .title = "Miss rates by associativity, blocked and 6-D",
            .source = std::string(IndependentModel) + "the experiment: Hakura and Gupta 1997",
            .method = "The floor of 1024 texels, lines of 64 bytes, tiles of 8x8 pixels.",
            .tables = {table},
            .claims = {{"6-D blocking makes a direct-mapped cache of 8 KB more than 4 times better",
                        fmt::format("{:.1f} times", blocked / six_d),
                        blocked > 4 * six_d}},
            .plots = {{"p3_ways", svg(plot)}}};
}

Experiment miss_rates_by_tile() {
    struct Case {
        const char* name;
        Order order;
        std::vector<double> expected; // 2, 4, 8, 16 KB
    };
    const auto tiles = [](std::uint32_t width) { return Order{work::Traversal::Tiled, width}; };
    const std::vector<Case> cases{{"scan lines", Scan, {3.69, 3.55, 3.39, 2.33}},
                                  {"tiles of 4", tiles(4), {1.43, 1.39, 1.31, 1.19}},
                                  {"tiles of 8", tiles(8), {1.06, 1.03, 0.98, 0.85}},
                                  {"tiles of 16", tiles(16), {1.13, 0.85, 0.81, 0.75}},
                                  {"tiles of 32", tiles(32), {1.00, 0.96, 0.77, 0.68}},
                                  {"tiles of 64", tiles(64), {2.11, 0.81, 0.77, 0.72}}};
    Table table{"Misses, % of the texels read", {"order", "2 KB", "4 KB", "8 KB", "16 KB"}, {}};
    tools::Plot plot{
        "The floor of 256 texels, rasterized", "size of the cache", "misses, % of texels", {}};
    for (const Case& each : cases) {
        table.rows.push_back(miss_row(
            each.name,
            each.expected,
            floor_scene(256),
            [&](const Work& work, work::Granularity granularity) {
                const TexelStream stream =
                    texel_stream(work, MissMachine{each.order, Blocks4, granularity}.config());
                std::vector<double> rates;
                for (std::uint32_t lines = 32; lines <= 256; lines *= 2)
                    rates.push_back(stream.miss_percent(1, lines));
                return rates;
            },
            TilesRasterPart));
        tools::PlotSeries& series = plot.series.emplace_back();
        series.name = each.name;
        for (std::size_t i = 0; i < 4; ++i)
            series.points.emplace_back(std::uint64_t{2048} << i,
                                       table.rows.back().lines[1].values[i]);
    }
    const auto obtained = [&](std::size_t row, std::size_t column) {
        return table.rows[row].lines[1].values[column];
    };
    const auto penalty = obtained(5, 0) / obtained(4, 0);
    const bool grows = obtained(5, 1) < obtained(2, 1) && obtained(4, 3) < obtained(2, 3);
    return {
        .id = "P8",
        .title = "Miss rates by the rasterizer's tile",
        .source = std::string(IndependentModel) +
                  "the experiment: J. McCormack, R. McNamara, Tiled Polygon Traversal Using "
                  "Half-Plane Edge Functions, HWWS 2000",
        .method = "The floor of 256 texels, 4x4 blocks, fully associative, lines of 64 bytes.",
        .tables = {table},
        .claims = {{"a tile of 64 pixels outruns a cache of 2 KB: twice the misses of 32 pixels",
                    fmt::format("{:.2f} times", penalty),
                    penalty > 1.5},
                   {"the best tile grows with the cache: 64 before 8 at 4 KB, 32 before 8 at 16 KB",
                    "",
                    grows}},
        .plots = {{"p8_tiles", svg(plot)}}};
}

} // namespace ffgpu::experiments
