// What Verilator made, loaded on demand.

#pragma once

namespace ffgpu::tools {

// The function `name` of a library beside the drop-in ones. Throws InputError where it is not
// there, as in a build without Verilator.
void* rtl_function(const char* library, const char* name);

} // namespace ffgpu::tools
