// DesignSpace: machines to be compared, as SPACE.toml tells them: every combination of axes, a list
// of single ones, random samples (docs/sweep.md).

#pragma once

#include "tools/config/configuration.h"

#include <cstddef>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct DesignPoint {
    std::string id; // 16 digits, of all parameters: equal machines are one point
    Configuration configuration;
    std::vector<std::string> values; // of DesignSpace::parameters, as TOML has them
};

struct DesignSpace {
    std::vector<std::string> parameters; // that some axis varies, in alphabetical order
    std::vector<DesignPoint> points;     // in the order of the file; none twice
    std::size_t left_out = 0;            // combinations that no machine can have
    std::string why;                     // that of the first
};

inline constexpr std::size_t MostPoints = 1'000'000;

// Throws InputError with file and line: what is no space, an empty axis, a parameter that there is
// not, a value out of its range, a point of the list that is no machine, no point that is one.
DesignSpace read_design_space(const std::string& path);

} // namespace ffgpu::tools
