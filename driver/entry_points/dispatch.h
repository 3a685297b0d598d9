// The way of every GL call from its entry point to the function of ffgpu::gl::api that does it:
//
//   - While a display list is being compiled, the command goes to the list; it is carried out as
//     well if the list is GL_COMPILE_AND_EXECUTE, or if the command is never compiled.
//   - Between glBegin and glEnd all but the commands of vertices are errors.
//   - Vertices that wait to be merged with the next primitive are drawn before any other command
//     acts: it may change or read what they depend on.

#pragma once

#include "driver/context/context.h"
#include "driver/context/current.h"
#include "driver/entry_points/command.h"
#include "driver/lists/list_compiler.h"

#include <new>
#include <type_traits>

namespace ffgpu::gl {

// The command that `Function` of ffgpu::gl::api carries out, at once.
template <CommandClass Class, auto Function, class... Arguments>
auto execute(Context& context, Arguments... arguments) {
    if constexpr (Class == CommandClass::Immediate || Class == CommandClass::Compiled) {
        if (!context.settle_vertices())
            return std::invoke_result_t<decltype(Function), Context&, Arguments...>();
    }
    return Function(context, arguments...);
}

// As the application calls it.
template <Command Id, CommandClass Class, auto Function, class... Arguments>
auto dispatch(Arguments... arguments) noexcept {
    using Result = std::invoke_result_t<decltype(Function), Context&, Arguments...>;
    Context* const context = current_context();
    if (!context) return Result();
    try {
        if constexpr (Class != CommandClass::Immediate) {
            if (context->compiling()) [[unlikely]] {
                compile<Id, Class, Function>(*context, arguments...);
                if (!context->lists().executing_too()) return Result();
            }
        }
        return execute<Class, Function>(*context, arguments...);
    } catch (const std::bad_alloc&) {
        context->error(GL_OUT_OF_MEMORY);
        return Result();
    }
}

} // namespace ffgpu::gl
