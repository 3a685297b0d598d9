#include "driver/entry_points/entry.h"

#include "driver/commands/declarations.h"
#include "driver/entry_points/dispatch.h"

namespace ffgpu::gl::entry {

// glTexImage3DEXT takes its internal format as a GLenum, glTexImage3D as a GLint: the same bits.
#pragma GCC diagnostic ignored "-Wsign-conversion"

#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    result name parameters noexcept {                                                              \
        return dispatch<Command::name, CommandClass::command_class, &api::name> arguments;         \
    }
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    result name parameters noexcept {                                                              \
        return target arguments;                                                                   \
    }
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS

} // namespace ffgpu::gl::entry
