// FailureKeeper: a Device for a driver, through whose calls no exception may pass. What the device
// throws first is kept until who plays asks for it; what the driver wants after that is left out.

#pragma once

#include "model/device/device.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace ffgpu::tools {

class FailureKeeper final : public Device {
public:
    explicit FailureKeeper(Device& device)
        : device_(device) {}

    // Throws what is kept, once.
    void check_failure() {
        if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    }

    std::uint64_t memory_size() const override { return device_.memory_size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        kept([&] { device_.write_memory(at, bytes); });
    }
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override {
        kept([&] { device_.read_memory(at, bytes); });
        if (failed_) std::ranges::fill(bytes, std::byte{});
    }
    void submit(const CommandStream& commands) override {
        kept([&] { device_.submit(commands); });
    }
    void finish() override {
        kept([&] { device_.finish(); });
    }
    std::vector<const StatisticsGroup*> statistics() const override { return device_.statistics(); }

private:
    template <class Call>
    void kept(Call&& call) {
        if (failed_) return;
        try {
            call();
        } catch (const std::bad_alloc&) { // The driver's own business: GL_OUT_OF_MEMORY.
            throw;
        } catch (...) {
            failure_ = std::current_exception();
            failed_ = true;
        }
    }

    Device& device_;
    std::exception_ptr failure_;
    bool failed_ = false;
};

} // namespace ffgpu::tools
