// Completion scripts for shells.

#pragma once

#include "tools/manual/program_text.h"

#include <string>

namespace ffgpu::tools {

std::string bash_completion(const ProgramText& program);
std::string zsh_completion(const ProgramText& program);
std::string fish_completion(const ProgramText& program);

} // namespace ffgpu::tools
