// VertexRing: device memory for vertices and indices that are drawn once. The device does commands
// and memory writes in order, so a place may be written again as soon as it was drawn from.

#pragma once

#include "driver/objects/device_block.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace ffgpu::gl {

class VertexRing {
public:
    explicit VertexRing(std::shared_ptr<MemoryAllocator> memory)
        : memory_(std::move(memory)) {}

    // What place() can give at most; 0 if device memory is full.
    std::uint64_t bytes() {
        if (!block_) allocate();
        return block_.bytes();
    }

    // A place for `bytes`, or nothing if they are more than bytes().
    std::optional<DeviceAddress> place(std::uint64_t bytes) {
        if (bytes > this->bytes()) return std::nullopt;
        if (next_ + bytes > block_.bytes()) next_ = 0;
        const auto address = static_cast<DeviceAddress>(block_.address() + next_);
        next_ += (bytes + 63) / 64 * 64;
        return address;
    }

private:
    static constexpr std::uint64_t WantedBytes = 8u << 20;
    static constexpr std::uint64_t LeastBytes = 16u << 10;

    void allocate() {
        for (std::uint64_t size = WantedBytes; size >= LeastBytes && !block_; size /= 2)
            block_ = DeviceBlock::allocate(memory_, size);
        next_ = 0;
    }

    std::shared_ptr<MemoryAllocator> memory_;
    DeviceBlock block_;
    std::uint64_t next_ = 0;
};

} // namespace ffgpu::gl
