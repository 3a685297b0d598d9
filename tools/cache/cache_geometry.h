// The shape of a cache.

#pragma once

#include <cstdint>

namespace ffgpu::tools {

struct CacheGeometry {
    std::uint32_t sets = 64, ways = 4, line_bytes = 64;

    std::uint64_t bytes() const { return std::uint64_t{sets} * ways * line_bytes; }
};

} // namespace ffgpu::tools
