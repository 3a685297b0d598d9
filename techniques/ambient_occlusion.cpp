#include "techniques/ambient_occlusion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ffgpu::techniques {
namespace {

// The largest slope towards `azimuth`, 0 if nothing rises there.
double horizon_slope(const Field& heights, int x, int y, double azimuth, int reach) {
    double slope = 0;
    for (int step = 1; step <= reach; ++step) {
        const int dx = static_cast<int>(std::lround(step * std::cos(azimuth)));
        const int dy = static_cast<int>(std::lround(step * std::sin(azimuth)));
        const int column = x + dx, row = y + dy;
        if (column < 0 || row < 0 || column >= heights.width || row >= heights.height) break;
        const double rise = heights.at(column, row) - heights.at(x, y);
        slope = std::max(slope, rise / std::hypot(dx, dy));
    }
    return slope;
}

} // namespace

Field ambient_occlusion(const Field& heights, const Horizon& horizon) {
    Field visible(heights.width, heights.height);
    for (int y = 0; y < heights.height; ++y) {
        for (int x = 0; x < heights.width; ++x) {
            double sum = 0;
            for (int i = 0; i < horizon.directions; ++i) {
                const double azimuth = 2 * std::numbers::pi * (i + 0.5) / horizon.directions;
                const double slope = horizon_slope(heights, x, y, azimuth, horizon.reach);
                sum += 1 / (1 + slope * slope); // cos^2 of the elevation whose tangent is `slope`
            }
            visible.at(x, y) = sum / horizon.directions;
        }
    }
    return visible;
}

} // namespace ffgpu::techniques
