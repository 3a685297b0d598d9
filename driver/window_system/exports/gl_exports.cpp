// The gl* functions that a drop-in library exports, from the one list of entry points.

#include "driver/commands/command.h"
#include "driver/entry_points/entry.h"
#include "driver/window_system/exports/window_hooks.h"
#include "driver/window_system/turn.h"

#include <string_view>
#include <type_traits>

namespace {

using ffgpu::gl::Command;
using ffgpu::gl::CommandClass;

// Commands of vertices that take binary32 numbers keep them as they are. What they come upon now
// and then, a full buffer or an attribute that is new, sets the mode itself.
constexpr bool only_moves(CommandClass command_class, std::string_view name) {
    return command_class == CommandClass::Vertex && (name.ends_with("f") || name.ends_with("fv"));
}

constexpr bool only_moves(Command id) {
    switch (id) {
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    case Command::name:                                                                            \
        return only_moves(CommandClass::command_class, #name);
#define GL_ALIAS(result, name, parameters, arguments, target)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
    default:
        return false;
    }
}

template <Command Id>
using TurnOf =
    std::conditional_t<only_moves(Id), ffgpu::gl::TurnIn<ffgpu::gl::CallersMode>, ffgpu::gl::Turn>;

} // namespace

#define FFGPU_EXPORT extern "C" __attribute__((visibility("default")))

#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    FFGPU_EXPORT result gl##name parameters {                                                      \
        const TurnOf<Command::name> turn;                                                          \
        ffgpu::gl::before<Command::name>();                                                        \
        return ffgpu::gl::entry::name arguments;                                                   \
    }
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    FFGPU_EXPORT result gl##name parameters {                                                      \
        const TurnOf<Command::target> turn;                                                        \
        ffgpu::gl::before<Command::target>();                                                      \
        return ffgpu::gl::entry::name arguments;                                                   \
    }
#include "driver/commands/commands.inc"
