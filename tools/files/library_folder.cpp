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
fs::path find_library_folder() {
    const fs::path above = this_program().parent_path().parent_path();
    for (const char* place : {FFGPU_INSTALLED_LIBRARIES, FFGPU_BUILT_LIBRARIES})
        if (fs::exists(above / place / "libGL.so.1")) return above / place;
    throw InputError("run: libGL.so.1 of ffgpu is neither in " +
                     (above / FFGPU_INSTALLED_LIBRARIES).string() + " nor in " +
                     (above / FFGPU_BUILT_LIBRARIES).string());
}

} // namespace ffgpu::tools
