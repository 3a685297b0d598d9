// Command: the identity of each GL command that is not an alias, and how it meets glBegin/glEnd and
// display lists.

#pragma once

#include <cstdint>

namespace ffgpu::gl {

enum class Command : std::uint16_t {
#define GL_COMMAND(result, name, parameters, arguments, command_class) name,
#define GL_ALIAS(result, name, parameters, arguments, target)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
    Count
};

// See driver/commands/generate.py, which sorts the commands.
enum class CommandClass : std::uint8_t { Immediate, Compiled, Inside, Vertex };

} // namespace ffgpu::gl
