#include "driver/window_system/exports/proc_address.h"

#include "driver/gl_types.h"

#include <algorithm>
#include <array>
#include <string>

#include <dlfcn.h>

// As gl_exports.cpp defines them. The system's headers declare some of them with the same types.
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    extern "C" result gl##name parameters;
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    GL_COMMAND(result, name, parameters, arguments, unused)
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS

namespace ffgpu::gl {
namespace {

struct Entry {
    std::string_view name;
    AnyFunction function;
};

// In the order of names: the list is sorted.
const auto Entries = std::to_array<Entry>({
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    {"gl" #name, reinterpret_cast<AnyFunction>(&gl##name)},
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    GL_COMMAND(result, name, parameters, arguments, unused)
#include "driver/commands/commands.inc"
});

// This library, whichever it is.
void* self() {
    static void* const handle = [] {
        Dl_info info{};
        ::dladdr(reinterpret_cast<const void*>(&glBegin), &info);
        return ::dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    }();
    return handle;
}

} // namespace

AnyFunction find_gl_function(std::string_view name) {
    const auto entry = std::ranges::lower_bound(Entries, name, {}, &Entry::name);
    return entry == Entries.end() || entry->name != name ? nullptr : entry->function;
}

AnyFunction find_function(std::string_view name) {
    if (!name.starts_with("glX") && !name.starts_with("egl")) return find_gl_function(name);
    void* const handle = self();
    return handle ? reinterpret_cast<AnyFunction>(::dlsym(handle, std::string(name).c_str()))
                  : nullptr;
}

} // namespace ffgpu::gl
