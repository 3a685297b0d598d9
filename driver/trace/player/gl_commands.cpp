#include "driver/trace/player/gl_commands.h"

#include "driver/entry_points/entry.h"
#include "driver/trace/player/names.h"

#include <map>
#include <tuple>
#include <utility>

namespace ffgpu::trace {
namespace {

// One instance a signature, not a command.
template <class Result, class... Parameters>
struct Caller {
    using Function = Result (*)(Parameters...) noexcept;

    static std::uint64_t call(GlCommand::AnyFunction any, Arguments& arguments) {
        return call(any, arguments, std::index_sequence_for<Parameters...>());
    }

private:
    template <std::size_t... Index>
    static std::uint64_t call(GlCommand::AnyFunction any,
                              [[maybe_unused]] Arguments& arguments,
                              std::index_sequence<Index...>) {
        const auto function = reinterpret_cast<Function>(any);
        // Braces evaluate from left to right.
        const std::tuple<Parameters...> parameters{arguments.get<Parameters>(Index)...};
        if (arguments.refused()) return 0;
        if constexpr (std::is_void_v<Result>) {
            std::apply(function, parameters);
            return 0;
        } else if constexpr (std::is_pointer_v<Result>) {
            return reinterpret_cast<std::uintptr_t>(std::apply(function, parameters));
        } else {
            return static_cast<std::uint64_t>(std::apply(function, parameters));
        }
    }
};

OffsetInto offset_into(std::string_view name) {
    const std::string_view base = without_vendor(name);
    const auto is_any = [&](auto... names) { return ((base == names) || ...); };
    if (base.ends_with("Pointer") || base == "InterleavedArrays") return OffsetInto::VertexBuffer;
    if (base.find("Elements") != std::string_view::npos) return OffsetInto::IndexBuffer;
    if (is_any("ReadPixels", "GetTexImage", "GetCompressedTexImage")) return OffsetInto::PixelPack;
    if (base.find("TexImage") != std::string_view::npos ||
        base.find("TexSubImage") != std::string_view::npos || base.starts_with("PixelMap") ||
        is_any("DrawPixels", "Bitmap", "PolygonStipple"))
        return OffsetInto::PixelUnpack;
    return OffsetInto::Nothing;
}

template <class Result, class... Parameters>
GlCommand describe(std::string_view name, Result (*function)(Parameters...) noexcept) {
    return {.name = name,
            .function = reinterpret_cast<GlCommand::AnyFunction>(function),
            .call = Caller<Result, Parameters...>::call,
            .array_size = find_array_size(name),
            .offset_into = offset_into(name)};
}

std::map<std::string_view, GlCommand> make_table() {
    std::map<std::string_view, GlCommand> table;
    const auto add = [&](const GlCommand& command) { table.emplace(command.name, command); };
#define GL_COMMAND(result, name, parameters, arguments, command_class)                             \
    add(describe(#name, gl::entry::name));
#define GL_ALIAS(result, name, parameters, arguments, target) add(describe(#name, gl::entry::name));
#include "driver/commands/commands.inc"
#undef GL_COMMAND
#undef GL_ALIAS
    return table;
}

} // namespace

const GlCommand* find_gl_command(std::string_view name) {
    static const std::map<std::string_view, GlCommand> table = make_table();
    if (!name.starts_with("gl")) return nullptr;
    const auto found = table.find(name.substr(2));
    return found == table.end() ? nullptr : &found->second;
}

} // namespace ffgpu::trace
