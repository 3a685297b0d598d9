// The pixel transfer operations (GL 1.5, 3.6.5) on rows of pixels.

#pragma once

#include "driver/state/pixel_state.h"

#include <array>
#include <cstdint>
#include <span>

namespace ffgpu::gl {

using PixelColor = std::array<float, 4>;

// Whether colours, depths or indices pass unchanged.
bool keeps_colors(const PixelState& transfer);
bool keeps_depths(const PixelState& transfer);

// Scale and bias, then the colour maps. Not clamped at the end.
void transfer_colors(const PixelState& transfer, std::span<PixelColor> row);

// Scale, bias and clamp to [0, 1].
void transfer_depths(const PixelState& transfer, std::span<double> row);

// Shift and offset; stencil indices then take the S_TO_S map.
void transfer_stencil(const PixelState& transfer, std::span<std::int32_t> row);

// Shift and offset, then the maps from an index to red, green, blue and alpha. There are no
// colour-index buffers: GL turns indices into colours here.
void transfer_indices(const PixelState& transfer, std::span<std::int32_t> row, PixelColor* colors);

} // namespace ffgpu::gl
