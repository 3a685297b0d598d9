// What is in a file: a trace, a device capture, a work file.

#pragma once

#include <string>

namespace ffgpu::tools {

// Lines for people. Throws InputError.
std::string describe_file(const std::string& path);

} // namespace ffgpu::tools
