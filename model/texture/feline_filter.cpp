// Feline: the elliptic weighted average by probes along a line, as hardware with a trilinear filter
// can do it (McCormack, Perry, Farkas and Jouppi, Feline: fast elliptical lines for anisotropic
// texture mapping, SIGGRAPH 1999, section 3).
//
// The pixel's circle of radius 1 is an ellipse among the texels of level 0,
//
//     A U^2 + B U V + C V^2 = A C - B^2 / 4,
//     A = vx^2 + vy^2,  B = -2 (ux vx + uy vy),  C = ux^2 + uy^2
//
//     root = sqrt((A - C)^2 + B^2)
//     major = sqrt((A + C + root) / 2),  minor = |ux vy - uy vx| / major,  each at least 1
//
// whose longer axis lies along (C - A + root, -B). On it stand as many trilinear probes as cover
// it, each as wide as the ellipse:
//
//     n = min(floor(2 major / minor - 1 + 1/2), probes)
//     minor = 2 major / (n + 1) where n is less than 2 major / minor - 1
//     level = log2 minor,  step = 2 (major - minor) / (n - 1)
//     probe i at (i - (n - 1) / 2) step,  weight 2^(-6 d^2),  d its distance over major

#include "model/texture/gaussian_weights.h"
#include "model/texture/probe_filter.h"
#include "model/texture/weighted_mean.h"
#include "model/texture/wide_filters.h"
#include "model/texture/wide_texels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace ffgpu {
namespace {

// Texels: several times the largest image. Squares of squares stay ordinary numbers.
constexpr float LongestSide = 0x1p15f;

struct Axes {
    float major = 1, minor = 1;       // radii in texels of level 0
    std::array<float, 2> direction{}; // of the longer one, of length 1; 0 for a circle
};

Axes axes_of(const TexelSteps& steps) {
    const auto& [ux, vx] = steps.x;
    const auto& [uy, vy] = steps.y;
    const float a = vx * vx + vy * vy;
    const float b = -2 * (ux * vx + uy * vy);
    const float c = ux * ux + uy * uy;
    const float root = std::sqrt((a - c) * (a - c) + b * b);
    const float major = std::sqrt((a + c + root) * 0.5f);
    Axes axes;
    if (!(major > 1)) return axes;
    axes.major = major;
    axes.minor = std::max(std::fabs(ux * vy - uy * vx) / major, 1.0f);
    // Two forms of one direction: that whose sum is not a difference.
    axes.direction = c >= a ? std::array{c - a + root, -b} : std::array{-b, a - c + root};
    const auto& [u, v] = axes.direction;
    const float length = std::sqrt(u * u + v * v);
    if (length > 0) axes.direction = {u / length, v / length};
    return axes;
}

// The probes of a pixel, in steps of texture coordinates.
struct ProbeLine {
    unsigned probes = 1;
    std::array<float, 2> step{};
    float squared_step = 0; // in radii of the longer axis
    float minor = 1;
};

ProbeLine line_of(const Axes& axes, unsigned most) {
    ProbeLine line{.minor = axes.minor};
    const float wanted = 2 * (axes.major / axes.minor) - 1;
    const float probes = std::min(std::floor(wanted + 0.5f), static_cast<float>(most));
    if (probes < wanted) line.minor = 2 * axes.major / (probes + 1);
    line.probes = static_cast<unsigned>(probes);
    if (line.probes == 1) return line;
    const float length = 2 * (axes.major - line.minor) / (probes - 1);
    line.step = {axes.direction[0] * length, axes.direction[1] * length};
    line.squared_step = (length / axes.major) * (length / axes.major);
    return line;
}

} // namespace

Rgba filter_feline(const TextureUnit& unit,
                   const SampledFragment& fragment,
                   const QuadSampling& quad,
                   const FilterWitness& witness) {
    const Axes axes = axes_of(texel_steps(unit, quad, 0, LongestSide));
    const ProbeLine line = line_of(axes, unit.max_probes);
    const auto square = std::bit_cast<std::uint32_t>(line.minor * line.minor);
    const QuadSampling sampling =
        choose_levels(unit, level_of_detail(unit, {.x = square, .y = square}, 1));
    const std::array<float, 2> step{line.step[0] / static_cast<float>(unit.size[0]),
                                    line.step[1] / static_cast<float>(unit.size[1])};
    const float middle = static_cast<float>(line.probes - 1) * 0.5f;
    WeightedMean sum;
    for (unsigned i = 0; i < line.probes; ++i) {
        const float at = static_cast<float>(i) - middle;
        const std::uint32_t weight = gaussian_weight(at * at * line.squared_step);
        SampledFragment probe = fragment;
        probe.coord.s = move_to_probe(fragment.coord.s, step[0], at);
        probe.coord.t = move_to_probe(fragment.coord.t, step[1], at);
        sum.add(filter_levels(unit, probe, sampling, witness.weighted(weight)), weight);
    }
    return sum.mean();
}

} // namespace ffgpu
