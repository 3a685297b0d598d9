// Copies a rectangle of pixels between surfaces, as CopyRectangleCommand says.

#pragma once

#include "model/device/commands.h"

#include <cstddef>
#include <span>

namespace ffgpu {

// Colour to colour and depth to depth, each uncompressed format to each. A command whose
// rectangles leave their surfaces, or whose surfaces leave memory, does nothing.
void copy_rectangle(const CopyRectangleCommand& copy, std::span<std::byte> memory);

} // namespace ffgpu
