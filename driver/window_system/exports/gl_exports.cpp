// The gl* functions that a drop-in library exports, from the one list of entry points.

#include "driver/entry_points/entry.h"
#include "driver/window_system/process_gpu.h"

#define FFGPU_EXPORT extern "C" __attribute__((visibility("default")))

#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    FFGPU_EXPORT result gl##name parameters {                                                      \
        const ffgpu::gl::ProcessGpu::Turn turn;                                                    \
        return ffgpu::gl::entry::name arguments;                                                   \
    }
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    GL_COMMAND(result, name, parameters, arguments, unused)
#include "driver/entry_points/commands.inc"
