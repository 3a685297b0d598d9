#include "driver/window_system/exports/proc_address.h"

#include "driver/gl_types.h"

#include <algorithm>
#include <array>

// As gl_exports.cpp defines them. The system's headers declare some of them with the same types.
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    extern "C" result gl##name parameters;
#define GL_ALIAS(result, name, parameters, arguments, target)                                      \
    GL_COMMAND(result, name, parameters, arguments, unused)
#include "driver/entry_points/commands.inc"
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
#include "driver/entry_points/commands.inc"
});

} // namespace

AnyFunction find_gl_function(std::string_view name) {
    const auto entry = std::ranges::find(Entries, name, &Entry::name);
    return entry == Entries.end() ? nullptr : entry->function;
}

} // namespace ffgpu::gl
