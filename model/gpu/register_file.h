// RegisterFile: the device's registers as the command stream writes them, and snapshots of them for
// the draws.

#pragma once

#include "model/device/registers.h"

#include <cstdint>
#include <memory>
#include <span>

namespace ffgpu {

class RegisterFile {
public:
    const Registers& values() const { return values_; }

    // Words of the register at `address`; 0: there is none.
    static std::size_t word_count(std::uint32_t address);

    enum class Change : std::uint8_t {
        None,
        Geometry, // of a register that only geometry and vertex fetch read
        Pixels,
    };

    // `words` has word_count(address) elements. Returns what the write changed.
    Change write(std::uint32_t address, std::span<const std::uint32_t> words);

    // The values as they are; the same object until a register changes.
    std::shared_ptr<const Registers> snapshot();

private:
    Registers values_;
    std::shared_ptr<const Registers> snapshot_;
};

} // namespace ffgpu
