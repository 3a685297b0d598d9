#include "driver/entry_points/entry.h"

#include "driver/entry_points/declarations.h"
#include "driver/entry_points/dispatch.h"

namespace ffgpu::gl::entry {

#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    result name parameters noexcept {                                                              \
        return dispatch<Command::name, CommandClass::command_class, &api::name> arguments;         \
    }
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    result name parameters noexcept {                                                              \
        return target arguments;                                                                   \
    }
#include "driver/entry_points/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS

} // namespace ffgpu::gl::entry
