// The Gaussian of the elliptic filter and of Feline, which is its form in hardware: exp(-2 d^2) at
// the distance d from the ellipse's centre, 1 at its edge.

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

namespace ffgpu {

constexpr unsigned WeightSteps = 128;

// round(255 exp(-2 k / 128))
constexpr auto GaussianWeights = [] {
    constexpr double Step = 0.98449643700540845; // exp(-2 / 128)
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
