// Copies a rectangle of pixels between surfaces, as CopyRectangleCommand says.

#pragma once

#include "model/device/commands.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

// Colour to colour and depth to depth, each uncompressed format to each. A command whose
// rectangles leave their surfaces, or whose surfaces leave memory, does nothing.
//
// Between surfaces with the same number of samples each sample is copied. From more to one they
// are resolved: colour to mean_rgba8(), depth and stencil to sample 0. From one to more every
// sample gets the pixel. Of several pictures the destination gets the mean, rounded as samples' is.
void copy_rectangle(const CopyRectangleCommand& copy, std::span<std::byte> memory);

// The mean of each channel, to nearest, halves up.
std::uint32_t mean_rgba8(const std::array<std::uint32_t, MaxSamples>& samples);

} // namespace ffgpu
