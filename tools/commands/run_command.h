// Starting a program on the drop-in libraries.

#pragma once

#include <string>
#include <vector>

namespace ffgpu::tools {

struct Environment {
    std::string name, value;
};

// Runs the program with these variables set, and returns its exit status; as the shell, 128 + the
// number of the signal that ended it. Throws InputError if it cannot be started.
int run_program(const std::vector<std::string>& command,
                const std::vector<Environment>& environment);

} // namespace ffgpu::tools
