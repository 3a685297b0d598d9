// Where the samples of a pixel are: four in a rotated square, no two in one row or column, so that
// an edge near the horizontal or the vertical passes them one by one.

#pragma once

#include "model/packets/rectangle.h"
#include "model/raster/edge.h"

#include <array>

namespace ffgpu {

// From the pixel's centre, in 1/256 pixel, y up: (-2, -6), (6, -2), (-6, 2), (2, 6) sixteenths.
constexpr std::array<SubPixelPoint, MaxSamples> SamplePositions{
    {{-32, -96}, {96, -32}, {-96, 32}, {32, 96}}};

// The pixels that may have a sample in low <= (x, y) < high.
inline Rectangle sampled_pixels(SubPixelPoint low, SubPixelPoint high) {
    constexpr int Half = 1 << (SubPixelBits - 1), Reach = 96;
    const auto first = [](std::int32_t at) { return (at - Half - Reach + 255) >> SubPixelBits; };
    const auto end = [](std::int32_t at) { return (at - Half + Reach + 255) >> SubPixelBits; };
    return {first(low.x), first(low.y), end(high.x), end(high.y)};
}

} // namespace ffgpu
