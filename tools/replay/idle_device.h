// IdleDevice: takes everything and does nothing, so that what a player and the driver cost by
// themselves can be timed. What is read back is zero.

#pragma once

#include "model/device/device.h"

#include <algorithm>

namespace ffgpu::tools {

class IdleDevice final : public Device {
public:
    explicit IdleDevice(std::uint64_t memory_bytes)
        : memory_bytes_(memory_bytes) {}

    std::uint64_t memory_size() const override { return memory_bytes_; }
    void write_memory(DeviceAddress, std::span<const std::byte>) override {}
    void read_memory(DeviceAddress, std::span<std::byte> bytes) override {
        std::fill(bytes.begin(), bytes.end(), std::byte{0});
    }
    void submit(const CommandStream&) override {}
    void finish() override {}
    std::vector<const StatisticsGroup*> statistics() const override { return {}; }

private:
    const std::uint64_t memory_bytes_;
};

} // namespace ffgpu::tools
