// A program that asks for a later OpenGL than there is sees an error code at most: what it asked
// for is told to who started it by `ffgpu run`.

#pragma once

namespace ffgpu::gl {

// Once a process; programs that ask for less and less ask for the most first.
void tell_refused_version(int major, int minor);

} // namespace ffgpu::gl
