// Why a program that was to draw on ffgpu did not.

#pragma once

#include <string>

namespace ffgpu::tools {

// One line for people about `program`, a path or a name to be found in PATH: that it never made an
// OpenGL context on ffgpu, and why if its file tells (it drops its environment for the rights of
// another user or group; it is linked statically) or its exit status.
std::string unused_reason(const std::string& program, int status);

} // namespace ffgpu::tools
