// Where the shared objects that belong to this program lie.

#pragma once

#include <filesystem>

namespace ffgpu::tools {

// The file that this process runs. Throws InputError where the system does not tell.
std::filesystem::path this_program();

// The folder of the drop-in libraries and of what ffgpu loads on demand, in an installation or in
// the build tree. Throws InputError where there is none.
std::filesystem::path find_library_folder();

} // namespace ffgpu::tools
