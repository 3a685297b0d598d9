// Configurations by text: what a file of another kind says of parameters, and each parameter's
// value.

#pragma once

#include "tools/config/configuration.h"

#include <map>
#include <string>

namespace ffgpu::tools {

// Sets the parameters that TOML text names. Throws InputError as read_config_file() does, with
// `source` and the text's lines as the place.
void apply_text(const std::string& text, const std::string& source, Configuration& configuration);

// Each parameter's path with its value as TOML writes it.
std::map<std::string, std::string> parameter_values(const Configuration& configuration);

} // namespace ffgpu::tools
