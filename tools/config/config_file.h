// Configurations as TOML: a table a group, a key a parameter.

#pragma once

#include "tools/config/configuration.h"

#include <string>

namespace ffgpu::tools {

// Sets the parameters that the file, or preset:NAME, names. Throws InputError for a key that does
// not exist (with the nearest one that does), a wrong type, or a value out of range.
void read_config_file(const std::string& path, Configuration& configuration);

// The same for one assignment, "texel_cache.ways = 8"; a choice needs no quotes there. `option` is
// the one that asked for it, which an error names.
void apply_setting(const std::string& setting,
                   Configuration& configuration,
                   const std::string& option = "--set");

// All parameters with unit, range and meaning in comments. What read_config_file() reads.
std::string to_toml(const Configuration& configuration);

} // namespace ffgpu::tools
