// Starting a program on the drop-in libraries.

#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ffgpu::tools {

// The folder of the drop-in libraries that belongs to this program, in an installation or in the
// build tree. Throws InputError where there is none.
std::filesystem::path find_drop_in_folder();

struct Environment {
    std::string name, value;
};

// Runs the program with these variables set, and returns its exit status; as the shell, 128 + the
// number of the signal that ended it. Throws InputError if it cannot be started.
int run_program(const std::vector<std::string>& command,
                const std::vector<Environment>& environment);

} // namespace ffgpu::tools
