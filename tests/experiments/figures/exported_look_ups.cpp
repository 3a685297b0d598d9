// P14: the look-ups that are exported, in another program's cache.

#include "tests/experiments/figures/all.h"
#include "tests/support/temporary_file.h"
#include "tests/work/din_player.h"
#include "tools/cache/cache_study.h"
#include "tools/export/export.h"

#include <fstream>
#include <random>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

constexpr tools::FrameRange Frames{0, 0};
constexpr unsigned Shapes = 10;

std::vector<std::string> exported(const std::string& trace) {
    const TemporaryFile file("", ".din");
    tools::export_trace({.input = trace, .output = file.path(), .frames = Frames});
    std::ifstream text(file.path());
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

Experiment exported_look_ups() {
    const std::string trace = std::string(FFGPU_SOURCE_DIR) + "/traces/corridor.trace";
    tools::CacheStudyOptions study{.input = trace,
                                   .frames = Frames,
                                   .clients = {work::LookupClient::Texel},
                                   .line_bytes = {64}};
    tools::CacheStudyResult result;
    tools::study_caches(study, result);
    const tools::CurveResult& curve = result.curves.front();
    const std::vector<std::string> lines = exported(trace);
    const auto shapes = tools::told_geometries(study, curve);
    std::mt19937 random(14);
    Table table{"Of all look-ups of a frame", {"sets x ways", "look-ups", "misses"}, {}, 0};
    tools::Plot plot{"The corridor's texels", "size of the cache, as drawn", "misses"};
    tools::PlotSeries& series =
        plot.series.emplace_back(tools::PlotSeries{"fully associative", {}});
    for (std::uint32_t size = 16; size <= 1024; size *= 2)
        series.points.emplace_back(64 * size,
                                   static_cast<double>(curve.sums.counts(1, size).misses));
    for (unsigned i = 0; i < Shapes; ++i) {
        const tools::CacheGeometry& shape = shapes[random() % shapes.size()];
        test::PlainCache cache(shape.sets, shape.ways);
        test::play_din(lines, cache);
        const work::CacheCounts counts = curve.sums.counts(shape.sets, shape.ways);
        const std::vector<double> expected{static_cast<double>(cache.counts.accesses),
                                           static_cast<double>(cache.counts.misses)};
        table.rows.push_back({fmt::format("{} x {}", shape.sets, shape.ways),
                              expected,
                              {within_points("one pass",
                                             expected,
                                             {static_cast<double>(counts.accesses),
                                              static_cast<double>(counts.misses)},
                                             0)}});
    }
    return {.id = "P14",
            .title = "Exported look-ups in another program's cache",
            .source = "Expected: a plain cache that reads the file as Dinero III does (M. D. Hill, "
                      "J. Edler, DineroIII), and shares no code with ffgpu",
            .method = "`ffgpu export --format din` of a frame of traces/corridor.trace against "
                      "`ffgpu cache`, ten seeded shapes.",
            .tables = {table},
            .plots = {{"p14_look_ups", svg(plot)}}};
}

} // namespace ffgpu::experiments
