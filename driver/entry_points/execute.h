// Carries out a command of ffgpu::gl::api at once, as the dispatcher and display lists do.
//
//   - Between glBegin and glEnd all but the commands of vertices are errors.
//   - Vertices that wait to be merged with the next primitive are drawn before any other command
//     acts: it may change or read what they depend on.

#pragma once

#include "driver/commands/command.h"
#include "driver/context/context.h"

#include <type_traits>

namespace ffgpu::gl {

template <CommandClass Class, auto Function, class... Arguments>
auto execute(Context& context, Arguments... arguments) {
    if constexpr (Class == CommandClass::Immediate || Class == CommandClass::Compiled) {
        if (!context.settle_vertices())
            return std::invoke_result_t<decltype(Function), Context&, Arguments...>();
    }
    return Function(context, arguments...);
}

} // namespace ffgpu::gl
