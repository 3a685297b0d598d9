// The one judge of what a command stream may ask for: a stream may come from a file, and no stage
// is to meet an enumerator that does not exist or an address outside memory. What takes up which
// bytes is in extents.h.
//
// Registers are judged when something is drawn with them, not when they are written: they are
// written one by one, and what stands between two writes need not fit together.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers.h"

#include <cstdint>

namespace ffgpu {

// Each throws InputError with what is wrong; the caller adds where.
void validate(const Registers& registers, std::uint64_t memory_size);
void validate(const DrawCommand& draw, const Registers& registers, std::uint64_t memory_size);
void validate(const DrawImageCommand& image, std::uint64_t memory_size);
void validate(const CopyRectangleCommand& copy, std::uint64_t memory_size);
void validate(const StoreSampleCounterCommand& store, std::uint64_t memory_size);

// A picture that is handed over: Format::None or an empty one is none.
void validate_picture(const Surface& picture, std::uint64_t memory_size);

} // namespace ffgpu
