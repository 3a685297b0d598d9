// Sizes as people write them: 512 B, 16 KB, 2 MB.

#pragma once

#include <cstdint>
#include <string>

#include <fmt/format.h>

namespace ffgpu::tools {

inline std::string size_name(std::uint64_t bytes) {
    constexpr std::uint64_t K = 1024;
    return bytes < K       ? fmt::format("{} B", bytes)
           : bytes < K * K ? fmt::format("{} KB", bytes / K)
                           : fmt::format("{} MB", bytes / K / K);
}

} // namespace ffgpu::tools
