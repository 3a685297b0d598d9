// The texture environment of one unit: a combiner for colour and one for alpha (GL 1.5, 3.8.13).
//
// Arithmetic: arguments are n / 255. The operation and the scale (1, 2 or 4) are carried out
// exactly, the result is clamped to [0, 1] and rounded once, to nearest, ties up.
// docs/arithmetic/fragment.md has the formulas.

#pragma once

#include "model/device/registers/texture.h"
#include "model/memory/pixel_format.h"

#include <array>

namespace ffgpu {

struct CombineInputs {
    std::array<PixelColor, TextureUnits> texture; // A unit that is not sampled is UnsampledTexture.
    PixelColor primary;
    PixelColor previous; // the result of the unit before; of the first one the primary colour
};

constexpr PixelColor UnsampledTexture{0, 0, 0, 255};

// The specification of one enabled unit for one fragment. Sources and operations beyond their
// lists read as Zero and act as Replace; a scale beyond 4 is 4.
PixelColor combine(const Combiner& combiner, const CombineInputs& inputs);

} // namespace ffgpu
