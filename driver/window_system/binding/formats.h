// The pixel formats that GLX and EGL offer.

#pragma once

#include "driver/framebuffer/drawable.h"

#include <vector>

namespace ffgpu::gl {

// All of them, in no special order; with accumulation buffers only where wanted (EGL has none).
std::vector<PixelFormat> offered_formats(bool with_accumulation);

constexpr int ColorBits = 8;         // of red, green and blue
constexpr int AccumulationBits = 16; // of each channel

} // namespace ffgpu::gl
