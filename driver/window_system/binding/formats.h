// The pixel formats that GLX and EGL offer.

#pragma once

#include "driver/framebuffer/drawable.h"

#include <vector>

namespace ffgpu::gl {

// All of them, in no special order but single-sampled ones first; with accumulation buffers only
// where wanted (EGL has none). With FFGPU_SAMPLES=4 in the environment only multisampled ones.
std::vector<PixelFormat> offered_formats(bool with_accumulation);

constexpr int ColorBits = 8;         // of red, green and blue
constexpr int AccumulationBits = 16; // of each channel

} // namespace ffgpu::gl
