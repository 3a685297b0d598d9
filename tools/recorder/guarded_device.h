// GuardedDevice: a Device for programs, through whose frames no InputError may pass: a capture that
// cannot be written is one, and is handed to who ends the process.

#pragma once

#include "model/base/input_error.h"
#include "model/device/device.h"

#include <functional>
#include <utility>

namespace ffgpu::tools {

class GuardedDevice final : public Device {
public:
    // `fail` does not return.
    GuardedDevice(Device& device, std::function<void(const InputError&)> fail)
        : device_(device)
        , fail_(std::move(fail)) {}

    std::uint64_t memory_size() const override { return device_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        guarded([&] { device_.write_memory(at, bytes); });
    }
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override {
        guarded([&] { device_.read_memory(at, bytes); });
    }
    void submit(const CommandStream& commands) override {
        guarded([&] { device_.submit(commands); });
    }
    void finish() override {
        guarded([&] { device_.finish(); });
    }
    std::vector<const StatisticsGroup*> statistics() const override { return device_.statistics(); }

private:
    template <class Call>
    void guarded(Call&& call) {
        try {
            call();
        } catch (const InputError& error) {
            fail_(error);
        }
    }

    Device& device_;
    const std::function<void(const InputError&)> fail_;
};

} // namespace ffgpu::tools
