// TOML of the files that people write for ffgpu: configurations, suites, design spaces.

#pragma once

#include <string>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace ffgpu::tools {

// Both throw InputError: one line with source, or path, and line. A file may have 16 MiB.
toml::table parse_toml(const std::string& text, const std::string& source);
toml::table read_toml_file(const std::string& path);

} // namespace ffgpu::tools
