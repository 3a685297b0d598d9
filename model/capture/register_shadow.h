// RegisterShadow: follows a command stream and knows what the device's registers hold.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers.h"

#include <memory>
#include <span>

namespace ffgpu::capture {

class RegisterShadow {
public:
    // `words`: a well-formed stream.
    void follow(std::span<const std::uint32_t> words);

    const Registers& registers() const { return *registers_; }

private:
    void write(std::uint32_t address, std::span<const std::uint32_t> words);

    std::unique_ptr<Registers> registers_ = std::make_unique<Registers>();
};

} // namespace ffgpu::capture
