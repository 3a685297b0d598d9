// What glXGetProcAddress, eglGetProcAddress and OSMesaGetProcAddress answer.

#pragma once

#include <string_view>

namespace ffgpu::gl {

using AnyFunction = void (*)();

// The exported function of this name ("glBegin"), or null where there is none.
AnyFunction find_gl_function(std::string_view name);

// The same, and the functions of the window system that the library exports ("glXSwapBuffers").
AnyFunction find_function(std::string_view name);

} // namespace ffgpu::gl
