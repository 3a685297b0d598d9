// Charts of miss rates, a curve's each: misses over size, a line for 1, 2, 4 and 8 ways and for
// fully associative caches.

#pragma once

#include "tools/cache/cache_study.h"

#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

constexpr std::string_view CurvePlotPrefix = "misses";

struct NamedPlot {
    std::string file; // its name: CurvePlotPrefix, then what it shows
    std::string svg;
};

std::vector<NamedPlot> curve_plots(const CacheStudyOptions& options,
                                   const CacheStudyResult& result);

} // namespace ffgpu::tools
