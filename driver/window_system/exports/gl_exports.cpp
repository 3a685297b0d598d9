// The gl* functions that a drop-in library exports, from the one list of entry points.

#include "driver/commands/command.h"
#include "driver/entry_points/entry.h"
#include "driver/window_system/exports/window_hooks.h"
#include "driver/window_system/turn.h"

#define FFGPU_EXPORT extern "C" __attribute__((visibility("default")))

#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    FFGPU_EXPORT result gl##name parameters {                                                      \
        const ffgpu::gl::Turn turn;                                                                \
        ffgpu::gl::before<ffgpu::gl::Command::name>();                                             \
        return ffgpu::gl::entry::name arguments;                                                   \
    }
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    FFGPU_EXPORT result gl##name parameters {                                                      \
        const ffgpu::gl::Turn turn;                                                                \
        ffgpu::gl::before<ffgpu::gl::Command::target>();                                           \
        return ffgpu::gl::entry::name arguments;                                                   \
    }
#include "driver/commands/commands.inc"
