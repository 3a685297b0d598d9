// Blending, logic operation and write mask of one pixel (GL 1.5, 4.1.7 to 4.1.9, 4.2.2).
//
// Arithmetic: source, destination and factors are n / 255. Add, Subtract and ReverseSubtract form
// both products exactly, add or subtract them, clamp to [0, 1] and round once:
//
//     round(clamp(s fs + d fd, 0, 65025) / 255)
//
// Min and Max ignore the factors.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/memory/pixel_format.h"

#include <cstdint>

namespace ffgpu {

// The specification. Factors beyond their list are Zero, equations beyond theirs Add.
PixelColor blend(const Blend& state, PixelColor source, PixelColor destination);

// Bitwise, on words of any pixel format.
std::uint32_t apply_logic_op(LogicOp op, std::uint32_t source, std::uint32_t destination);

// What a draw with this state does to the colour targets, besides the write mask.
enum class ColorOperation : std::uint8_t { Replace, Blend, Logic };

ColorOperation color_operation(const Blend& state);

} // namespace ffgpu
