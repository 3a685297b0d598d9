#include "tools/rtl/rtl_library.h"

#include "model/base/input_error.h"
#include "tools/files/library_folder.h"

#include <string>

#include <dlfcn.h>

namespace ffgpu::tools {

void* rtl_function(const char* library, const char* name) {
    const std::string path = library_path(library).string();
    void* const handle = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = handle ? ::dlsym(handle, name) : nullptr;
    if (!symbol)
        throw InputError("--rtl: the units in RTL are not there, which Verilator makes when ffgpu "
                         "is built: " +
                         std::string(::dlerror()));
    return symbol;
}

} // namespace ffgpu::tools
