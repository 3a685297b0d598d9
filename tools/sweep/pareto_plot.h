// Cycles of a trace's points against what they cost, as an SVG file; the best are joined.

#pragma once

#include <string>
#include <vector>

namespace ffgpu::tools {

struct ParetoPoint {
    double price = 0, cycles = 0;
    bool is_best = false;
    std::string name; // shown where the mouse is
};

struct ParetoPlot {
    std::string title, prices; // what the first axis says
    std::vector<ParetoPoint> points;
};

std::string svg(const ParetoPlot& plot);

} // namespace ffgpu::tools
