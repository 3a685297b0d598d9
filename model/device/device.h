// Device: everything that a driver can do to a GPU. The functional GPU implements it, and so do
// the capture writer and the tests' recorders.

#pragma once

#include "model/base/statistics.h"
#include "model/device/commands.h"
#include "model/device/layout/formats.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu {

class Device {
public:
    virtual ~Device() = default;

    // Bytes of device memory; addresses run from 0. Memory starts as zeroes.
    virtual std::uint64_t memory_size() const = 0;

    // Memory and commands act in the order of the calls, as if each finished before the next
    // began. A range outside memory is a mistake of the driver's and is checked.
    virtual void write_memory(DeviceAddress at, std::span<const std::byte> bytes) = 0;
    virtual void read_memory(DeviceAddress at, std::span<std::byte> bytes) = 0;
    virtual void submit(const CommandStream& commands) = 0;

    // Returns when everything submitted has been carried out.
    virtual void finish() = 0;

    // Counters of the device's functional units, since its creation: of all that was submitted
    // once finish() has returned.
    virtual std::vector<const StatisticsGroup*> statistics() const = 0;
};

} // namespace ffgpu
