// DeviceBlock: a range of device memory that gives itself back.

#pragma once

#include "driver/memory_allocator.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace ffgpu::gl {

class DeviceBlock {
public:
    DeviceBlock() = default;
    DeviceBlock(DeviceBlock&& other) noexcept { swap(other); }
    DeviceBlock& operator=(DeviceBlock&& other) noexcept {
        DeviceBlock moved(std::move(other));
        swap(moved);
        return *this;
    }
    ~DeviceBlock() {
        if (memory_) memory_->release(address_);
    }

    // Empty where device memory is full (GL_OUT_OF_MEMORY).
    static DeviceBlock allocate(const std::shared_ptr<MemoryAllocator>& memory,
                                std::uint64_t bytes) {
        DeviceBlock block;
        if (const auto address = memory->allocate(bytes)) {
            block.memory_ = memory;
            block.address_ = *address;
            block.bytes_ = bytes;
        }
        return block;
    }

    explicit operator bool() const { return memory_ != nullptr; }
    DeviceAddress address() const { return address_; }
    std::uint64_t bytes() const { return bytes_; }

private:
    void swap(DeviceBlock& other) noexcept {
        memory_.swap(other.memory_);
        std::swap(address_, other.address_);
        std::swap(bytes_, other.bytes_);
    }

    std::shared_ptr<MemoryAllocator> memory_; // An object may outlive its share group.
    DeviceAddress address_ = 0;
    std::uint64_t bytes_ = 0;
};

} // namespace ffgpu::gl
