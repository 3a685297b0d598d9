// Commands that this OpenGL does not have: those of later versions and of extensions that are not
// advertised. Programs which choose at run time what they call are linked with them, often such
// that they do not start while one is missing. Called all the same, they are GL_INVALID_OPERATION;
// glXGetProcAddress does not know them.

#include "driver/context/context.h"
#include "driver/context/current.h"
#include "driver/window_system/turn.h"

#include <cstdint>

// Each has the address of this function. What parameters they have does not matter to it, nor what
// they return to those who look at the error first: it is zero.
extern "C" std::uintptr_t ffgpu_later_command() {
    const ffgpu::gl::Turn turn;
    if (ffgpu::gl::Context* const context = ffgpu::gl::current_context())
        context->error(GL_INVALID_OPERATION);
    return 0;
}

#define GL_LATER_COMMAND(name)                                                                     \
    extern "C" __attribute__((visibility("default"), alias("ffgpu_later_command")))                \
    std::uintptr_t later_##name() __asm__("gl" #name);
#include "driver/window_system/exports/later_commands.inc"
