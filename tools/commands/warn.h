// A warning: one line on stderr.

#pragma once

#include <cstdio>
#include <string>

namespace ffgpu::tools {

inline void warn(const std::string& line) {
    std::fprintf(stderr, "ffgpu: warning: %s\n", line.c_str());
}

// Of settings that decide nothing, if there are any.
inline void warn_of_settings(const std::string& without_effect) {
    if (!without_effect.empty())
        warn("--set " + without_effect + ": has no effect without --timing");
}

} // namespace ffgpu::tools
