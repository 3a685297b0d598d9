// What `ffgpu cache` is asked for, as text, and what it means.

#pragma once

#include "tools/cache/cache_study.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ffgpu::tools {

struct CacheArguments {
    std::string input, output, frames, config, first_level, miss_map;
    std::vector<std::string> settings, clients, layouts, orders;
    std::vector<std::uint32_t> line_bytes;
    std::uint32_t most_sets = 4096, most_ways = 32;
    bool unmerged = false;
};

void add_cache_options(CLI::App& verb, CacheArguments& arguments);

// Throws InputError.
CacheStudyOptions resolve(const CacheArguments& arguments);

// Throws InputError that names the option.
work::LookupClient parse_client(const char* option, const std::string& text);

// "64x4x32": sets, ways, bytes of a line. Throws InputError that names the option.
CacheGeometry parse_geometry(const std::string& option, const std::string& text);

} // namespace ffgpu::tools
