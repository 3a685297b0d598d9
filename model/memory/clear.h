// Clears a rectangle of the targets, as ClearCommand says: under the write masks of colour and
// stencil, every colour target, all samples, dithered where the target has less than eight bits a
// channel.

#pragma once

#include "model/arith/srgb.h"
#include "model/device/commands.h"
#include "model/memory/pixel_fill.h"
#include "model/packets/rectangle.h"

#include <array>
#include <cstddef>
#include <span>

namespace ffgpu {

// What a clear to `color`, rgba8, leaves in colour target `i`, before its precision.
constexpr std::uint32_t
cleared_color(const FragmentControl& control, unsigned i, std::uint32_t color) {
    return control.is_srgb(i) ? srgb_encoded_rgba8(color) : color;
}

// What a clear does to each target, in the order of Targets::for_each; no bits where nothing.
std::array<PixelFill, ColorTargets + 1> target_fills(const ClearCommand& clear,
                                                     const Registers& registers);

// All samples of a target; otherwise as clear_rectangle().
void fill_target(const Surface& target,
                 const PixelFill& fill,
                 const Rectangle& rectangle,
                 std::span<std::byte> memory);

// `rectangle` is cut to each target. A target that does not fit into memory is left alone.
void clear_rectangle(const ClearCommand& clear,
                     const Registers& registers,
                     const Rectangle& rectangle,
                     std::span<std::byte> memory);

} // namespace ffgpu
