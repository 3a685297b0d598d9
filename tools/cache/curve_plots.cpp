#include "tools/cache/curve_plots.h"

#include "tools/cache/cache_report.h"
#include "tools/cache/svg_plot.h"

#include <fmt/format.h>

namespace ffgpu::tools {
namespace {

constexpr std::uint64_t LeastBytes = 512, MostBytes = std::uint64_t{4} << 20;

double miss_percent(const work::CacheCounts& counts) {
    return 100.0 * static_cast<double>(counts.misses) / static_cast<double>(counts.accesses);
}

// `ways` 0: fully associative. Up to the size beyond which nothing but compulsory misses is left.
PlotSeries
series_of(const CacheStudyOptions& options, const CurveResult& curve, std::uint32_t ways) {
    PlotSeries series{ways == 0 ? "full" : fmt::format("{} way{}", ways, ways > 1 ? "s" : ""), {}};
    for (std::uint64_t bytes = LeastBytes; bytes <= MostBytes; bytes *= 2) {
        const std::uint64_t lines = bytes / curve.line_bytes;
        const std::uint64_t sets = ways == 0 ? 1 : lines / ways;
        if (sets > options.most_sets) break;
        if (lines == 0 || sets == 0) continue;
        const work::CacheCounts counts = curve.sums.counts(
            static_cast<std::uint32_t>(sets), static_cast<std::uint32_t>(ways == 0 ? lines : ways));
        series.points.emplace_back(bytes, miss_percent(counts));
        if (counts.misses == counts.compulsory) break;
    }
    return series;
}

// "texel, blocked, tiled 8" as part of a file's name.
std::string file_name(const CurveResult& curve) {
    std::string name;
    for (const char c : variant_name(curve))
        if (c != ',') name += c == ' ' ? '_' : c;
    return fmt::format("{}_{}_{}.svg", CurvePlotPrefix, name, curve.line_bytes);
}

} // namespace

std::vector<NamedPlot> curve_plots(const CacheStudyOptions& options,
                                   const CacheStudyResult& result) {
    std::vector<NamedPlot> plots;
    for (const CurveResult& curve : result.curves) {
        if (curve.sums.counts(1, 1).accesses == 0) continue;
        Plot plot{fmt::format("{}, lines of {} bytes", variant_name(curve), curve.line_bytes),
                  "size of the cache",
                  "misses, % of look-ups",
                  {}};
        for (const std::uint32_t ways : {1u, 2u, 4u, 8u, 0u})
            if (ways <= options.most_ways) plot.series.push_back(series_of(options, curve, ways));
        plots.push_back({file_name(curve), svg(plot)});
    }
    return plots;
}

} // namespace ffgpu::tools
