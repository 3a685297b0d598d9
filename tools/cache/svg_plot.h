// A chart of curves over sizes, or counts, in powers of two, as an SVG file that shows in any
// browser, light or dark.

#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ffgpu::tools {

struct PlotSeries {
    std::string name;
    std::vector<std::pair<std::uint64_t, double>> points; // by rising size; sizes are above 0
};

struct Plot {
    std::string title;
    std::string sizes, values; // what the axes say
    std::vector<PlotSeries> series = {};
    bool counts = false; // along the first axis are numbers, not sizes in bytes
};

std::string svg(const Plot& plot);

} // namespace ffgpu::tools
