// SPACE.toml as it stands: parameters with the values that each may have.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu::tools {

struct Axis {
    std::string parameter;            // texel_cache.ways
    std::vector<std::string> values;  // as TOML writes them; never empty
    std::size_t line = 1, column = 1; // of the file
};

struct SpaceFile {
    std::string path;
    std::string base;                    // a configuration, or preset:NAME; empty: the defaults
    std::size_t base_line = 1;           // of the file
    std::vector<Axis> fixed;             // one value each, of every point
    std::vector<Axis> grid;              // every combination
    std::vector<std::vector<Axis>> list; // points, one value each
    std::vector<Axis> random_axes;
    std::uint64_t random_samples = 0, random_seed = 0;
};

// Throws InputError. Whether the parameters exist is not looked at.
SpaceFile read_space_file(const std::string& path);

} // namespace ffgpu::tools
