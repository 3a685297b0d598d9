// The way of every GL call from its entry point to the function of ffgpu::gl::api that does it.
// While a display list is being compiled, the command goes to the list; it is carried out as well
// if the list is GL_COMPILE_AND_EXECUTE, or if the command is never compiled.

#pragma once

#include "driver/context/context.h"
#include "driver/context/current.h"
#include "driver/entry_points/compile.h"
#include "driver/entry_points/execute.h"

#include <new>
#include <type_traits>

namespace ffgpu::gl {

// While a list is being compiled. Out of line to the end, so that vertices outside of lists keep no
// registers for it.
template <Command Id, CommandClass Class, auto Function, class... Arguments>
[[gnu::noinline, gnu::cold]] auto dispatch_to_list(Context& context, Arguments... arguments) {
    using Result = std::invoke_result_t<decltype(Function), Context&, Arguments...>;
    compile<Id, Class, Function>(context, arguments...);
    if (!context.lists().executing_too()) return Result();
    return execute<Class, Function>(context, arguments...);
}

template <Command Id, CommandClass Class, auto Function, class... Arguments>
auto dispatch(Arguments... arguments) noexcept {
    using Result = std::invoke_result_t<decltype(Function), Context&, Arguments...>;
    Context* const context = current_context();
    if (!context) return Result();
    try {
        if constexpr (Class != CommandClass::Immediate) {
            if (context->lists().compiling()) [[unlikely]]
                return dispatch_to_list<Id, Class, Function>(*context, arguments...);
        }
        return execute<Class, Function>(*context, arguments...);
    } catch (const std::bad_alloc&) {
        context->error(GL_OUT_OF_MEMORY);
        return Result();
    }
}

} // namespace ffgpu::gl
