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

// Whether the command makes fragments: "glBegin", "glDrawElementsBaseVertex" ...
constexpr bool draws(std::string_view name) {
    if (name.starts_with("glDrawBuffer")) return false;
    for (const std::string_view start : {"glDraw",
                                         "glMultiDraw",
                                         "glCallList",
                                         "glRect",
                                         "glBitmap",
                                         "glEvalMesh",
                                         "glArrayElement"})
        if (name.starts_with(start)) return true;
    return name == "glBegin" || name == "glClear";
}

} // namespace ffgpu::trace
