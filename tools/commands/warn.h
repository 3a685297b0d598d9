// What is said on stderr: a line each.

#pragma once

#include <cstdio>
#include <string>

namespace ffgpu::tools {

// What is said of std::bad_alloc.
inline constexpr const char* OutOfMemory =
    "out of memory: of the host, or of the device for what it is given to draw";

inline void warn(const std::string& line) {
    std::fprintf(stderr, "ffgpu: warning: %s\n", line.c_str());
}

// Of settings that decide nothing, if there are any.
inline void warn_of_settings(const std::string& without_effect) {
    if (!without_effect.empty())
        warn("--set " + without_effect + ": has no effect without --timing");
}

} // namespace ffgpu::tools
