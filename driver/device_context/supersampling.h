// Supersampling: a window is several pictures, each drawn by all commands with its own part of the
// pixel in the pixel's centre, and averaged where somebody looks (Drawable).
//
// The parts are Hammersley's points: picture i of n takes the samples at ((i + 1/2) / n, (r + 1/2)
// / n), r being i with its bits in the other order. Whatever power of two n is, each of n columns
// and each of n rows of a pixel has one sample, and so has, of 4 and 16, each square of a grid.

#pragma once

#include "model/device/commands.h"

#include <array>

namespace ffgpu::gl {

class DeviceContext;

// In pixels from the pixel's lower left corner; the centre where there is one picture.
std::array<float, 2> sample_position(unsigned picture, unsigned pictures);

// `commands`, which draw, once for each picture of the draw target. Registers are left as they
// were. Fragments that a query counts are those of the first picture.
void submit_to_pictures(DeviceContext& context, const CommandStream& commands);

} // namespace ffgpu::gl
