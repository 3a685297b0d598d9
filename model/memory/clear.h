// Clears a rectangle of the targets, as ClearCommand says: under the write masks of colour and
// stencil, every colour target, all samples, dithered where the target has less than eight bits a
// channel.

#pragma once

#include "model/device/commands.h"
#include "model/packets/rectangle.h"

#include <cstddef>
#include <span>

namespace ffgpu {

// `rectangle` is cut to each target. A target that does not fit into memory is left alone.
void clear_rectangle(const ClearCommand& clear,
                     const Registers& registers,
                     Rectangle rectangle,
                     std::span<std::byte> memory);

} // namespace ffgpu
