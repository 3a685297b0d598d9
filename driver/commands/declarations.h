// Declares ffgpu::gl::api::Name(Context&, parameters...) for every command of OpenGL that is not an
// alias, from the one list of entry points. Each is defined in the file of driver/api/ that is
// named after its chapter of the specification.

#pragma once

#include "driver/gl_types.h"

namespace ffgpu::gl {

class Context;

namespace api {

#define GL_WITH_CONTEXT(...) (Context & context __VA_OPT__(, ) __VA_ARGS__)
#define GL_COMMAND(result, name, parameters, arguments, list)                                      \
    result name GL_WITH_CONTEXT parameters;
#define GL_ALIAS(result, name, parameters, arguments, target)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
#undef GL_WITH_CONTEXT

} // namespace api
} // namespace ffgpu::gl
