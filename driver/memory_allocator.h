// Allocates device memory: first fit over free ranges, neighbours merged on release.

#pragma once

#include "model/device/layout/formats.h"

#include <cstdint>
#include <map>
#include <optional>

namespace ffgpu::gl {

class MemoryAllocator {
public:
    static constexpr std::uint64_t Alignment = 64;

    // Manages [begin, end) of device memory.
    MemoryAllocator(std::uint64_t begin, std::uint64_t end);

    // `bytes` at a multiple of Alignment; nothing if no free range is large enough
    // (GL_OUT_OF_MEMORY).
    std::optional<DeviceAddress> allocate(std::uint64_t bytes);

    // Gives back a range that allocate() returned.
    void release(DeviceAddress address);

    std::uint64_t bytes_in_use() const { return bytes_in_use_; }

private:
    std::map<std::uint64_t, std::uint64_t> free_; // begin -> end
    std::map<std::uint64_t, std::uint64_t> used_; // begin -> end
    std::uint64_t bytes_in_use_ = 0;
};

} // namespace ffgpu::gl
