// Words of commands that ffgpu prints, as a shell reads them.

#pragma once

#include <string>

namespace ffgpu::tools {

std::string shell_quoted(const std::string& text);

// Quoted only where the shell would make something else of it.
std::string shell_word(const std::string& text);

} // namespace ffgpu::tools
