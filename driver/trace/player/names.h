// Names of GL commands.

#pragma once

#include <string_view>

namespace ffgpu::trace {

// "GenTexturesEXT" -> "GenTextures".
constexpr std::string_view without_vendor(std::string_view name) {
    for (const std::string_view vendor : {"ARB", "EXT", "ATI", "NV", "MESA", "APPLE", "SGIS"})
        if (name.ends_with(vendor)) return name.substr(0, name.size() - vendor.size());
    return name;
}

} // namespace ffgpu::trace
