// CensusDevice: a device that draws nothing. It keeps memory and registers, and counts what it is
// told to do. Throws std::bad_alloc where the host has no memory for it.

#pragma once

#include "model/device/device.h"
#include "model/device/register_file.h"
#include "model/gpu/functional_gpu.h"
#include "tools/info/census.h"

#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

namespace ffgpu::tools {

class CensusDevice final : public Device {
public:
    const Census& census() const { return census_; }
    // What comes from now on is no work: a snapshot.
    void set_counting(bool counts) { counts_ = counts; }

    std::uint64_t memory_size() const override { return MemoryBytes; }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override;
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override;
    void submit(const CommandStream& commands) override;
    void finish() override {}
    std::vector<const StatisticsGroup*> statistics() const override { return {}; }

private:
    static constexpr std::uint64_t MemoryBytes = DeviceMemory::DefaultBytes;
    struct Free {
        void operator()(void* memory) const { std::free(memory); }
    };

    static std::byte* zeroes() {
        void* const memory = std::calloc(1, MemoryBytes);
        if (memory == nullptr) throw std::bad_alloc();
        return static_cast<std::byte*>(memory);
    }
    void count(const CommandReader& reader);
    std::byte* memory(DeviceAddress at, std::size_t bytes) const;

    // Zeroes, which the host backs as they are touched.
    const std::unique_ptr<std::byte, Free> memory_{zeroes()};
    RegisterFile registers_;
    Census census_;
    bool counts_ = true;
};

} // namespace ffgpu::tools
