// P1 and P5: misses of fully associative caches by size, and the bytes that they save.

#include "tests/experiments/figures/all.h"
#include "tests/experiments/figures/miss_machine.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

constexpr std::uint32_t LeastLines = 16, Sizes = 7; // 1 to 64 KB of lines of 64 bytes

struct Case {
    const char* name;
    const BothWays* scene;
    Placing placing;
    Order order;
    std::vector<double> expected;
};

// Misses in percent of the texels read.
std::vector<Case> cases() {
    const BothWays *const flat = &flat_scene(), *const turned = &turned_scene(30),
                          *const across = &turned_scene(90), *const f256 = &floor_scene(256),
                          *const f1024 = &floor_scene(1024);
    return {
        {"flat, linear, scan lines",
         flat,
         Linear,
         Scan,
         {3.17, 3.17, 1.57, 1.57, 1.57, 1.57, 1.57}},
        {"flat, linear, columns",
         flat,
         Linear,
         Column,
         {26.57, 26.57, 26.57, 26.57, 26.57, 4.69, 1.61}},
        {"flat, 4x4, scan lines", flat, Blocks4, Scan, {7.83, 7.83, 7.83, 4.68, 1.58, 1.58, 1.58}},
        {"flat, 4x4, columns", flat, Blocks4, Column, {7.83, 7.83, 7.83, 4.69, 1.58, 1.58, 1.58}},
        {"flat, 4x4, 8x8 tiles", flat, Blocks4, Tiles8, {2.36, 2.36, 2.36, 2.36, 2.36, 1.58, 1.58}},
        {"turned by 30, linear, scan lines",
         turned,
         Linear,
         Scan,
         {15.38, 15.38, 15.38, 15.38, 15.38, 1.64, 1.64}},
        {"turned by 30, 4x4, scan lines",
         turned,
         Blocks4,
         Scan,
         {10.06, 10.06, 10.06, 10.06, 1.60, 1.60, 1.60}},
        {"turned by 30, 4x4, 8x8 tiles",
         turned,
         Blocks4,
         Tiles8,
         {2.64, 2.64, 2.64, 2.64, 2.64, 1.60, 1.60}},
        // As its columns, and its tiles, not turned.
        {"turned by 90, linear, scan lines",
         across,
         Linear,
         Scan,
         {26.57, 26.57, 26.57, 26.57, 26.57, 4.69, 1.61}},
        {"turned by 90, 4x4, 8x8 tiles",
         across,
         Blocks4,
         Tiles8,
         {2.36, 2.36, 2.36, 2.36, 2.36, 1.58, 1.58}},
        {"floor 256, linear, scan lines",
         f256,
         Linear,
         Scan,
         {4.87, 4.77, 4.63, 4.38, 3.87, 0.57, 0.52}},
        {"floor 256, linear, columns",
         f256,
         Linear,
         Column,
         {20.93, 20.06, 18.94, 18.04, 17.34, 3.63, 0.58}},
        {"floor 256, 4x4, scan lines",
         f256,
         Blocks4,
         Scan,
         {3.78, 3.69, 3.55, 3.39, 2.33, 0.55, 0.51}},
        {"floor 256, 4x4, 8x8 tiles",
         f256,
         Blocks4,
         Tiles8,
         {1.28, 1.06, 1.03, 0.98, 0.85, 0.74, 0.50}},
        {"floor 1024, linear, columns",
         f1024,
         Linear,
         Column,
         {23.38, 23.14, 22.88, 22.74, 22.74, 19.38, 0.84}},
        {"floor 1024, 4x4, 8x8 tiles",
         f1024,
         Blocks4,
         Tiles8,
         {1.31, 1.10, 1.10, 1.09, 1.07, 0.95, 0.69}},
    };
}

std::vector<double> rates_by_size(const Work& work, const MissMachine& machine) {
    const TexelStream stream = texel_stream(work, machine.config());
    std::vector<double> rates;
    for (std::uint32_t i = 0; i < Sizes; ++i)
        rates.push_back(stream.miss_percent(1, LeastLines << i));
    return rates;
}

// The floor where the four pixels of a quad have the level of detail of its first, as a machine
// does that works in quads: what of a difference comes from that.
Work floor_with_levels_of_quads() {
    timing::Scene scene = timing::floor_scene(256);
    scene.sample = [own = scene.sample](double x, double y, timing::SceneSample& sample) {
        timing::SceneSample first;
        const auto even = [](double at) { return 2 * std::floor(at / 2) + 0.5; };
        if (own(even(x), even(y), first) && own(x, y, sample)) {
            sample.lambda = first.lambda;
            return true;
        }
        return own(x, y, sample);
    };
    return analytic(scene);
}

tools::PlotSeries curve(const std::string& name, const std::vector<double>& values) {
    tools::PlotSeries series{name, {}};
    for (std::size_t i = 0; i < values.size(); ++i)
        series.points.emplace_back(std::uint64_t{1024} << i, values[i]);
    return series;
}

Plot chart(const Table& table) {
    tools::Plot plot{
        "The floor of 256 texels, rasterized", "size of the cache", "misses, % of texels", {}};
    for (const Row& row : table.rows)
        if (row.name.starts_with("floor 256"))
            plot.series.push_back(curve(row.name.substr(11), row.lines[1].values));
    return {"p1_miss_rates", svg(plot)};
}

} // namespace

Experiment miss_rates_by_size() {
    Table table{"Misses, % of the texels read",
                {"scene, layout, order", "1 KB", "2 KB", "4 KB", "8 KB", "16 KB", "32 KB", "64 KB"},
                {}};
    for (const Case& each : cases())
        table.rows.push_back(
            miss_row(each.name,
                     each.expected,
                     *each.scene,
                     [&](const Work& work, work::Granularity granularity) {
                         return rates_by_size(work, {each.order, each.placing, granularity});
                     }));
    // At 32 KB, where a column's lines just fill the cache, the level of detail decides.
    const auto columns = std::find_if(table.rows.begin(), table.rows.end(), [](const Row& row) {
        return row.name == "floor 256, linear, columns";
    });
    columns->lines.push_back(
        {.how = "by formula, one level of detail a quad",
         .values = rates_by_size(floor_with_levels_of_quads(), {Column, Linear})});
    const Plot plot = chart(table);
    return {.id = "P1",
            .title = "Miss rates by the size of the cache",
            .source = std::string(IndependentModel) +
                      "the experiment is that of Z. Hakura, A. Gupta, The Design and Analysis of a "
                      "Cache Architecture for Texture Mapping, ISCA 1997",
            .method = "Fully associative LRU caches, lines of 64 bytes.",
            .tables = {table},
            .plots = {plot}};
}

Experiment bandwidth_saved() {
    constexpr double Least = 3, Most = 15; // as the paper has it
    Table table{"Bytes of texels read, a byte that the cache reads from memory",
                {"order, layout", "16 KB"},
                {}};
    tools::Plot plot{"Bytes saved on the floor, blocked, in tiles", "size of the cache", "factor"};
    const auto saved = [&](const Work& work, std::uint32_t lines) {
        const TexelStream stream = texel_stream(work, MissMachine{Tiles8, Blocks4}.config());
        return 4 * static_cast<double>(stream.reads) / (64 * stream.misses(1, lines));
    };
    const double expected = 7.4;
    const BothWays& scene = floor_scene(256);
    std::vector<double> sizes;
    for (std::uint32_t i = 0; i < Sizes; ++i)
        sizes.push_back(saved(scene.drawn, LeastLines << i));
    plot.series.push_back(curve("rasterized", sizes));
    const double drawn = saved(scene.drawn, 256);
    table.rows.push_back({"8x8 tiles, 4x4 blocks",
                          {expected},
                          {within_part("by formula", {expected}, {saved(scene.formula, 256)}, 0.01),
                           within_part("rasterized", {expected}, {drawn}, RasterPart)}});
    return {.id = "P5",
            .title = "Bytes that a texture cache saves",
            .source = "Hakura and Gupta 1997: \"at least three times and as much as fifteen "
                      "times\" less; 7.4 by the independent model of P1",
            .method = "The floor of 256 texels, trilinear; texels of 4 bytes, lines of 64.",
            .tables = {table},
            .claims = {{"a cache of 16 KB saves three to fifteen times",
                        fmt::format("{:.1f}", drawn),
                        Range{Least, Most}.holds(drawn)}},
            .plots = {{"p5_bytes_saved", svg(plot)}}};
}

} // namespace ffgpu::experiments
