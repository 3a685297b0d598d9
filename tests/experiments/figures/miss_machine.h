// Machines of the experiments on miss rates: raster order, texture layout, granularity; and their
// rows of figures from both ways to a scene.

#pragma once

#include "tests/experiments/figures/experiment.h"
#include "tests/experiments/figures/scenes.h"

#include <string>
#include <vector>

namespace ffgpu::experiments {

struct Order {
    work::Traversal traversal = work::Traversal::Tiled;
    std::uint32_t tile = 8;
};
inline constexpr Order Scan{work::Traversal::Scanline, 8}, Column{work::Traversal::Column, 8},
    Tiles8{};

struct Placing {
    work::Layout layout = work::Layout::Blocked;
    std::uint32_t block = 4;
};
inline constexpr Placing Linear{work::Layout::Linear, 4}, Blocks4{},
    SixD{work::Layout::Blocked6d, 4};

struct MissMachine {
    Order order;
    Placing placing;
    work::Granularity granularity = work::Granularity::Fragment;
    std::uint32_t line_bytes = 64;

    work::WorkConfig config() const;
};

// Points of misses that rounding and the scene's edges may cost against the independent model; the
// part of its figures that the real rasterizer may, whose level of detail is a quad's.
inline constexpr double Points = 0.05, RasterPart = 0.15, TilesRasterPart = 0.10;

// The figures of a machine by fragment, of the formula's and of the rasterizer's work, and by quad.
template <class Figures>
Row miss_row(const std::string& name,
             const std::vector<double>& expected,
             const BothWays& scene,
             const Figures& figures,
             double raster_part = RasterPart) {
    using work::Granularity;
    return {name,
            expected,
            {within_points(
                 "by formula", expected, figures(scene.formula, Granularity::Fragment), Points),
             within_part(
                 "rasterized", expected, figures(scene.drawn, Granularity::Fragment), raster_part),
             {.how = "rasterized, by quad", .values = figures(scene.drawn, Granularity::Quad)}}};
}

inline constexpr const char* IndependentModel =
    "An independent model of the scenes, which looks each texel up, fragment after fragment, in a "
    "cache with LRU replacement, computed for this project; ";

} // namespace ffgpu::experiments
