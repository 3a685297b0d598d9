// The GL as its callers see it: ffgpu::gl::entry::Name(parameters...) for every command, aliases
// included. A call acts on the current context; where the thread has none it does nothing and
// returns zero. No exception leaves it.

#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl::entry {

#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    result name parameters noexcept;
#define GL_ALIAS(result, name, parameters, arguments, target) result name parameters noexcept;
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS

} // namespace ffgpu::gl::entry
