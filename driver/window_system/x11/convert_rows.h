// From the device's pixels to those of an X visual.

#pragma once

#include "driver/window_system/x11/xlib.h"

#include <cstddef>
#include <span>

namespace ffgpu::gl {

// Fills `to` from rows of pixels r g b x of 8 bits each, the lowest row first; `stride` bytes lie
// between two rows.
void convert_rows(std::span<const std::byte> rows,
                  std::size_t stride,
                  XImage& to,
                  const Visual& visual);

} // namespace ffgpu::gl
