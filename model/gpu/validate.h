// Checks of what a command stream may ask for: a capture file can be damaged, and no stage is to
// meet an enumerator that does not exist or an address outside memory.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers.h"

#include <cstdint>

namespace ffgpu {

// Each throws InputError with what is wrong; the caller adds where.
void validate(const Registers& registers, std::uint64_t memory_size);
void validate(const DrawCommand& draw, const Registers& registers, std::uint64_t memory_size);
void validate(const DrawImageCommand& image);
void validate(const CopyRectangleCommand& copy, std::uint64_t memory_size);

} // namespace ffgpu
