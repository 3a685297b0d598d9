// Another program in place of this process.

#pragma once

#include <string>
#include <vector>

namespace ffgpu::tools {

// Runs words[0], found in PATH, with `words` as its arguments, in this process, as execvp() does.
// Comes back only where it cannot be run, with the reason in errno. For a child after fork().
void become(const std::vector<std::string>& words);

} // namespace ffgpu::tools
