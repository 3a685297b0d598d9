// The verb that tells its jobs, and what it leaves, which ffgpu they are of.

#pragma once

#include "tools/commands/commands.h"

namespace ffgpu::tools {

void add_sweep_command(CLI::App& application, Run& run, const char* version);

} // namespace ffgpu::tools
