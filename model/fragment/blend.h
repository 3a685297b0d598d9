// Blending, logic operation and write mask of one pixel (GL 1.5, 4.1.7 to 4.1.9, 4.2.2).
//
// Arithmetic: source, destination and factors are n / 255. Add, Subtract and ReverseSubtract form
// both products exactly, add or subtract them, clamp to [0, 1] and round once:
//
//     round(clamp(s fs + d fd, 0, 65025) / 255)
//
// Min and Max ignore the factors.
//
// Into a target of sRGB codes red, green and blue are light, n / 65535: the codes by their table,
// all else times 257. The same formula with 65535 in 255's place, encoded at last
// (model/arith/srgb.h). Alpha is blended as ever.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/fragment/quad_access.h"
#include "model/memory/pixel_format.h"
#include "model/packets/fragment_batch.h"

#include <cstdint>

namespace ffgpu {

// The specification. Factors beyond their list are Zero, equations beyond theirs Add.
PixelColor blend(const Blend& state, PixelColor source, PixelColor destination);
// The destination's and the result's red, green and blue are sRGB codes.
PixelColor blend_srgb(const Blend& state, PixelColor source, PixelColor destination);

// Bitwise, on words of any pixel format.
std::uint32_t apply_logic_op(LogicOp op, std::uint32_t source, std::uint32_t destination);

// What a draw with this state does to the colour targets, besides the write mask.
enum class ColorOperation : std::uint8_t { Replace, Blend, Logic };

ColorOperation color_operation(const Blend& state);

// --- On batches: rgba8 words, one a lane --------------------------------------------------------

void pack_color(const FragmentBatch& batch, LaneWords& colors);

// Blends batch.color with `colors`, in place. The kernel is chosen for the state.
using BlendKernel = void (*)(const Blend& state, const FragmentBatch& batch, LaneWords& colors);
BlendKernel choose_blend_kernel(const Blend& state);

// destination = source op destination, for `lanes` lanes.
void apply_logic_op(LogicOp op, const LaneWords& source, LaneWords& destination, unsigned lanes);

} // namespace ffgpu
