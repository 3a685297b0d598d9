// The pixel formats that GLX and EGL offer, and what a swap does.

#pragma once

#include "driver/framebuffer/drawable.h"

#include <vector>

namespace ffgpu::gl {

// All of them, in no special order but single-sampled ones first; with accumulation buffers only
// where wanted (EGL has none). With FFGPU_SAMPLES=4 in the environment only multisampled ones.
std::vector<PixelFormat> offered_formats(bool with_accumulation);

// With FFGPU_SWAP=exchange in the environment SwapMode::Exchange.
SwapMode swap_mode();

constexpr int ColorBits = 8;         // of red, green and blue
constexpr int AccumulationBits = 16; // of each channel

} // namespace ffgpu::gl
