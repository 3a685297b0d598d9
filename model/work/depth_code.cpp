#include "model/work/depth_code.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <utility>
#include <vector>

namespace ffgpu::work {
namespace {

using Depth = std::int64_t;

// a / b, b > 0, to nearest, halves up.
Depth rounded(Depth a, Depth b) {
    const Depth twice = 2 * a + b;
    return twice >= 0 ? twice / (2 * b) : -((-twice + 2 * b - 1) / (2 * b));
}

// A plane over the grid: a depth at (x0, y0), and what it rises over `run` pixels of each axis.
struct Plane {
    Depth at = 0, rise_x = 0, rise_y = 0;
    Depth x0 = 0, y0 = 0;
    Depth run_x = 1, run_y = 1;

    Depth operator()(Depth x, Depth y) const {
        return at + rounded((x - x0) * rise_x, run_x) + rounded((y - y0) * rise_y, run_y);
    }
};

// The depths that a plane is told by, and where they are. An axis of one pixel has no rise.
class PlanePoints {
public:
    // Through the corners of the grid.
    static PlanePoints corners(const DepthGrid& grid) {
        return {grid, {0, 0}, {grid.width - 1, 0}, {0, grid.height - 1}};
    }
    // Through the pixels at the first corner, or at the last.
    static PlanePoints first(const DepthGrid& grid) {
        return {
            grid, {0, 0}, {std::min(1u, grid.width - 1), 0}, {0, std::min(1u, grid.height - 1)}};
    }
    static PlanePoints last(const DepthGrid& grid) {
        const std::uint32_t x = grid.width - 1, y = grid.height - 1;
        return {grid, {x, y}, {x - std::min(1u, x), y}, {x, y - std::min(1u, y)}};
    }

    Plane of(std::span<const std::uint32_t> depths) const {
        return plane([&](const Point& point) { return depths[point.y * grid_.width + point.x]; });
    }
    void put(std::span<const std::uint32_t> depths, BitWriter& out) const {
        plane([&](const Point& point) {
            const std::uint32_t depth = depths[point.y * grid_.width + point.x];
            out.put(depth, grid_.bits);
            return depth;
        });
    }
    Plane get(BitReader& in) const {
        return plane([&](const Point&) { return in.get(grid_.bits); });
    }

private:
    struct Point {
        std::uint32_t x, y;
    };

    PlanePoints(const DepthGrid& grid, Point at, Point along_x, Point along_y)
        : grid_(grid)
        , at_(at)
        , along_x_(along_x)
        , along_y_(along_y) {}

    template <class DepthAt>
    Plane plane(DepthAt&& depth_at) const {
        Plane plane{.at = Depth{depth_at(at_)}, .x0 = at_.x, .y0 = at_.y};
        if (along_x_.x != at_.x) {
            const Depth run = Depth{along_x_.x} - at_.x;
            const Depth rise = Depth{depth_at(along_x_)} - plane.at;
            plane.run_x = std::abs(run);
            plane.rise_x = run < 0 ? -rise : rise;
        }
        if (along_y_.y != at_.y) {
            const Depth run = Depth{along_y_.y} - at_.y;
            const Depth rise = Depth{depth_at(along_y_)} - plane.at;
            plane.run_y = std::abs(run);
            plane.rise_y = run < 0 ? -rise : rise;
        }
        return plane;
    }

    DepthGrid grid_;
    Point at_, along_x_, along_y_;
};

// Bits of a signed number that hold `value`; none for 0.
unsigned signed_width(Depth value) {
    unsigned width = 0;
    while (width == 0 ? value != 0
                      : value < -(Depth{1} << (width - 1)) || value >= Depth{1} << (width - 1))
        ++width;
    return width;
}

constexpr unsigned WidestResidual = (1u << ResidualWidthBits) - 1;

// Calls each(index, x, y) for the grid's pixels, row after row.
template <class Each>
void for_each_pixel(const DepthGrid& grid, Each&& each) {
    std::size_t i = 0;
    for (std::uint32_t y = 0; y < grid.height; ++y)
        for (std::uint32_t x = 0; x < grid.width; ++x)
            each(i++, x, y);
}

// One or two planes; with two each pixel chooses the nearer.
struct Fit {
    std::vector<Depth> residuals;
    std::vector<std::uint8_t> second; // the pixel is of the second plane
    unsigned width = 0;

    Fit(const DepthGrid& grid,
        std::span<const std::uint32_t> depths,
        std::span<const Plane> planes) {
        for_each_pixel(grid, [&](std::size_t i, std::uint32_t x, std::uint32_t y) {
            const Depth depth = depths[i];
            Depth residual = depth - planes[0](x, y);
            const Depth other = planes.size() > 1 ? depth - planes[1](x, y) : residual;
            const bool takes_other = signed_width(other) < signed_width(residual);
            if (takes_other) residual = other;
            residuals.push_back(residual);
            second.push_back(takes_other);
            width = std::max(width, signed_width(residual));
        });
    }
    bool fits() const { return width <= WidestResidual; }
    void put_residuals(BitWriter& out) const {
        for (const Depth residual : residuals)
            out.put(static_cast<std::uint32_t>(residual), width);
    }
};

BitWriter raw_code(const DepthGrid& grid, std::span<const std::uint32_t> depths) {
    BitWriter out;
    out.put(static_cast<std::uint32_t>(DepthMode::Raw), DepthModeBits);
    for (const std::uint32_t depth : depths)
        out.put(depth, grid.bits);
    return out;
}

BitWriter plane_code(const DepthGrid& grid, std::span<const std::uint32_t> depths) {
    const PlanePoints points = PlanePoints::corners(grid);
    const std::array planes{points.of(depths)};
    const Fit fit(grid, depths, planes);
    if (!fit.fits()) return raw_code(grid, depths);
    BitWriter out;
    out.put(static_cast<std::uint32_t>(DepthMode::Plane), DepthModeBits);
    points.put(depths, out);
    out.put(fit.width, ResidualWidthBits);
    fit.put_residuals(out);
    return out;
}

BitWriter two_planes_code(const DepthGrid& grid, std::span<const std::uint32_t> depths) {
    const PlanePoints first = PlanePoints::first(grid), last = PlanePoints::last(grid);
    const std::array planes{first.of(depths), last.of(depths)};
    const Fit fit(grid, depths, planes);
    if (!fit.fits()) return raw_code(grid, depths);
    BitWriter out;
    out.put(static_cast<std::uint32_t>(DepthMode::TwoPlanes), DepthModeBits);
    first.put(depths, out);
    last.put(depths, out);
    out.put(fit.width, ResidualWidthBits);
    for (const std::uint8_t second : fit.second)
        out.put(second, 1);
    fit.put_residuals(out);
    return out;
}

} // namespace

void encode_depths(const DepthGrid& grid, std::span<const std::uint32_t> depths, BitWriter& out) {
    if (std::adjacent_find(depths.begin(), depths.end(), std::not_equal_to<>()) == depths.end()) {
        out.put(static_cast<std::uint32_t>(DepthMode::Uniform), DepthModeBits);
        out.put(depths[0], grid.bits);
        return;
    }
    BitWriter best = raw_code(grid, depths);
    for (const auto code : {plane_code, two_planes_code}) {
        BitWriter other = code(grid, depths);
        if (other.bits() < best.bits()) best = std::move(other);
    }
    out.append(best);
}

void decode_depths(const DepthGrid& grid, BitReader& in, std::span<std::uint32_t> depths) {
    const auto mode = static_cast<DepthMode>(in.get(DepthModeBits));
    if (mode == DepthMode::Uniform) {
        std::fill(depths.begin(), depths.end(), in.get(grid.bits));
        return;
    }
    if (mode == DepthMode::Raw) {
        for (std::uint32_t& depth : depths)
            depth = in.get(grid.bits);
        return;
    }
    std::array<Plane, 2> planes;
    const bool two = mode == DepthMode::TwoPlanes;
    planes[0] = (two ? PlanePoints::first(grid) : PlanePoints::corners(grid)).get(in);
    if (two) planes[1] = PlanePoints::last(grid).get(in);
    const unsigned width = in.get(ResidualWidthBits);
    std::vector<std::uint8_t> second(depths.size());
    for (std::uint8_t& choice : second)
        choice = two && in.get(1) != 0;
    for_each_pixel(grid, [&](std::size_t i, std::uint32_t x, std::uint32_t y) {
        depths[i] = static_cast<std::uint32_t>(planes[second[i]](x, y) + in.get_signed(width));
    });
}

} // namespace ffgpu::work
