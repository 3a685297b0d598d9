// The Gaussian of the elliptic filter and of Feline, which is its form in hardware: 2^(-6 d^2) at
// the distance d from the ellipse's centre, 1 at its edge.
//
// Heckbert's theory (1989) holds for any width: a resampling filter's variance is that of the
// pixel's prefilter, carried to the texture, and that of the reconstruction of texels; the ellipse
// has both by its "+ 1". What is to be met here is the mean over a pixel and over texels that are
// squares, so the Gaussian of unit area is the one nearest to a box of width 1 in the mean square:
//
//     d/dv of the integral of (box - gaussian of variance v)^2 = 0  <=>  exp(-1 / 8v) = 2^(-3/2)
//     v = 1 / (12 ln 2) = 0.120,  exp(-d^2 / 2v) = exp(-6 ln 2 d^2) = 2^(-6 d^2)
//
// exp(-2 d^2), as one often sees, has v = 1/4, more than the pixel's own 1/12 three times.

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace ffgpu {

constexpr unsigned WeightSteps = 128;

// round(255 2^(-6 k / 128))
constexpr auto GaussianWeights = [] {
    constexpr double Step = 0.96803079971393136; // 2^(-6 / 128)
    std::array<std::uint32_t, WeightSteps> table{};
    double value = 255;
    for (std::uint32_t& weight : table) {
        weight = static_cast<std::uint32_t>(value + 0.5);
        value *= Step;
    }
    return table;
}();

// Of a squared distance below 1; one that rounding made negative is 0.
constexpr std::uint32_t gaussian_weight(float squared_distance) {
    return GaussianWeights[static_cast<unsigned>(std::max(squared_distance, 0.0f) * WeightSteps)];
}

} // namespace ffgpu
