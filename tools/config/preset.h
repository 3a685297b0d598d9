// Presets as the command line knows them: --config preset:NAME, and the page that lists them.

#pragma once

#include "tools/config/configuration.h"

#include <string>
#include <string_view>

namespace ffgpu::tools {

// Whether a --config names a preset, not a file.
bool is_preset(std::string_view config);

// Sets the parameters of "preset:NAME". Throws InputError for a name that does not exist.
void apply_preset(const std::string& config, Configuration& configuration);

// A line a preset.
std::string list_presets();

// docs/presets.md: every parameter of every preset with its source.
std::string presets_page();

} // namespace ffgpu::tools
