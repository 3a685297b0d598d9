// The calls of a trace: how many of each, in which threads and contexts, from which extensions.

#pragma once

#include <string>

namespace ffgpu::tools {

// Lines for people. Throws InputError.
std::string describe_calls(const std::string& path);

} // namespace ffgpu::tools
