#include "tools/files/library_folder.h"

#include "model/base/input_error.h"

namespace ffgpu::tools {

namespace fs = std::filesystem;

fs::path this_program() {
    std::error_code missing;
    fs::path program = fs::read_symlink("/proc/self/exe", missing);
    if (missing)
        throw InputError("/proc/self/exe: cannot be read, which tells where ffgpu is: " +
                         missing.message());
    return program;
}

// Seen from the folder above the program's: of tools/ffgpu, bin/ffgpu and tests/tools_test alike.
fs::path library_path(const std::string& name) {
    const fs::path above = this_program().parent_path().parent_path();
    const fs::path installed = above / FFGPU_INSTALLED_LIBRARIES / name;
    return fs::exists(installed) ? installed : above / FFGPU_BUILT_LIBRARIES / name;
}

fs::path find_library_folder() {
    const fs::path library = library_path("libGL.so.1");
    if (fs::exists(library)) return library.parent_path();
    const fs::path above = this_program().parent_path().parent_path();
    throw InputError("run: libGL.so.1 of ffgpu is neither in " +
                     (above / FFGPU_INSTALLED_LIBRARIES).string() + " nor in " +
                     (above / FFGPU_BUILT_LIBRARIES).string());
}

} // namespace ffgpu::tools
