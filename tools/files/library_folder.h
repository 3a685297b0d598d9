// Where the shared objects that belong to this program lie.

#pragma once

#include <filesystem>
#include <string>

namespace ffgpu::tools {

// The file that this process runs. Throws InputError where the system does not tell.
std::filesystem::path this_program();

// A library that ffgpu loads on demand, in an installation or in a build tree, which may have been
// built without any other: where it is, or where it would be.
std::filesystem::path library_path(const std::string& name);

// The folder of the drop-in libraries. Throws InputError where they are not there.
std::filesystem::path find_library_folder();

} // namespace ffgpu::tools
