// P9: triangles through the plane w = 0, clipped and rasterized, against two-dimensional
// homogeneous rasterization, which clips nothing.

#include "tests/experiments/figures/all.h"
#include "tests/gpu/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

namespace ffgpu::experiments {
namespace {

constexpr int Size = 256;
constexpr unsigned Triangles = 400;

struct Corner {
    double x = 0, y = 0, w = 1; // of clip space; z is 0, so that only w > 0 clips
};
using Triangle = std::array<Corner, 3>;

// Corners on both sides of w = 0.
Triangle random_triangle(std::mt19937& random) {
    const auto within = [&](double limit) {
        return static_cast<double>(
            static_cast<float>(limit * (static_cast<double>(random() % 20001) / 10000 - 1)));
    };
    Triangle triangle;
    do {
        for (Corner& corner : triangle)
            corner = {within(3), within(3), within(2)};
    } while (
        std::all_of(triangle.begin(), triangle.end(), [](const Corner& c) { return c.w > 0; }) ||
        std::all_of(triangle.begin(), triangle.end(), [](const Corner& c) { return c.w <= 0; }));
    return triangle;
}

// The edge functions of M. Olano and T. Greer: the rows of the adjoint of the corners' matrix, in
// pixels. A point is inside where all have the sign of the determinant.
struct Edges {
    std::array<std::array<double, 3>, 3> rows; // a x + b y + c
    double determinant = 0;

    // How far, in pixels, a point is inside the nearest edge; below 0: outside.
    double inside(double x, double y) const {
        double least = 1e30;
        for (const auto& [a, b, c] : rows)
            least = std::min(
                least, std::copysign(1.0, determinant) * (a * x + b * y + c) / std::hypot(a, b));
        return least;
    }
    // To the nearest of the three lines.
    double distance(double x, double y) const {
        double least = 1e30;
        for (const auto& [a, b, c] : rows)
            least = std::min(least, std::fabs(a * x + b * y + c) / std::hypot(a, b));
        return least;
    }
};

Edges edges_of(const Triangle& triangle) {
    std::array<std::array<double, 3>, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
        const Corner& c = triangle[i];
        v[i] = {(c.x + c.w) * Size / 2, (c.y + c.w) * Size / 2, c.w};
    }
    const auto cross = [](const auto& p, const auto& q) {
        return std::array{
            p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
    };
    Edges edges{{cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])}, 0};
    for (std::size_t i = 0; i < 3; ++i)
        edges.determinant += edges.rows[0][i] * v[0][i];
    return edges;
}

std::vector<std::uint32_t> drawn(const Triangle& triangle) {
    static test::Scene scene(Size, Size);
    scene.clear(0);
    std::vector<test::Vertex> vertices;
    for (const Corner& c : triangle)
        vertices.push_back({static_cast<float>(c.x),
                            static_cast<float>(c.y),
                            0,
                            static_cast<float>(c.w),
                            1,
                            1,
                            1,
                            1,
                            0,
                            0});
    scene.draw(PrimitiveType::Triangles, vertices);
    return scene.picture();
}

struct Compared {
    std::uint64_t covered = 0, compared = 0, differing = 0;
    double farthest = 0;                   // from an edge, in pixels, of a pixel that differs
    std::array<std::uint64_t, 7> beyond{}; // differing pixels farther than 2^-7 ... 2^-1 pixels

    static double distance(std::size_t i) { return std::ldexp(1.0, static_cast<int>(i) - 7); }
};

// A pixel is held to the reference where its centre is farther than this from each edge: vertices
// are snapped to 1/256, and those that clipping makes are of binary32.
constexpr double Margin = 1.0 / 16;

void compare(const Triangle& triangle, Compared& all) {
    const Edges edges = edges_of(triangle);
    const std::vector<std::uint32_t> picture = drawn(triangle);
    for (int y = 0; y < Size; ++y)
        for (int x = 0; x < Size; ++x) {
            const double px = x + 0.5, py = y + 0.5, distance = edges.distance(px, py);
            const bool covered =
                picture[static_cast<std::size_t>(y) * Size + static_cast<std::size_t>(x)] != 0;
            all.covered += covered;
            all.compared += distance > Margin;
            if (covered == (edges.inside(px, py) > 0)) continue;
            all.farthest = std::max(all.farthest, distance);
            all.differing += distance > Margin;
            for (std::size_t i = 0; i < all.beyond.size(); ++i)
                all.beyond[i] += distance > Compared::distance(i);
        }
}

} // namespace

Experiment homogeneous_rasterization() {
    std::mt19937 random(9);
    Compared all;
    for (unsigned i = 0; i < Triangles; ++i)
        compare(random_triangle(random), all);
    tools::Plot plot{
        "Pixels that differ", "farther from an edge, 1/128 pixel", "pixels, of all triangles"};
    plot.counts = true;
    tools::PlotSeries& series = plot.series.emplace_back(tools::PlotSeries{"differing", {}});
    for (std::size_t i = 0; i < all.beyond.size(); ++i)
        series.points.emplace_back(std::uint64_t{1} << i, static_cast<double>(all.beyond[i]));
    Table table{"", {"triangles through w = 0", "pixels that differ"}, {}, 0};
    table.rows.push_back(
        {fmt::format("{} triangles, pixels farther than 1/16 from each edge", Triangles),
         {0},
         {within_points("clipped and rasterized", {0}, {static_cast<double>(all.differing)}, 0)}});
    return {.id = "P9",
            .title = "Homogeneous rasterization needs no clipping",
            .source = "M. Olano, T. Greer, Triangle Scan Conversion using 2D Homogeneous "
                      "Coordinates, HWWS 1997; expected are its edge functions, in binary64, "
                      "written from the paper",
            .method = "Random triangles with corners on both sides of w = 0: ffgpu clips them "
                      "where w is below 0 and rasterizes what is left; the reference clips "
                      "nothing. The rule: each pixel is equal whose centre is farther than 1/16 "
                      "pixel from the three lines through the edges.",
            .tables = {table},
            .claims = {{"the triangles are seen, and most pixels are held to the reference",
                        fmt::format("{} pixels covered, {} of {} compared",
                                    all.covered,
                                    all.compared,
                                    std::uint64_t{Triangles} * Size * Size),
                        all.covered > Triangles * 1000 &&
                            all.compared > std::uint64_t{Triangles} * Size * Size * 9 / 10}},
            .plots = {{"p9_edges", svg(plot)}}};
}

} // namespace ffgpu::experiments
