// RegisterFile: registers as a command stream writes them, and snapshots of them for the draws. The
// device has one, and so has whoever follows a stream.

#pragma once

#include "model/device/command_reader.h"
#include "model/device/registers.h"

#include <cstdint>
#include <memory>

namespace ffgpu {

class RegisterFile {
public:
    const Registers& values() const { return values_; }

    enum class Change : std::uint8_t {
        None,
        Geometry, // of a register that only geometry and vertex fetch read
        Pixels,
    };

    // Returns what the write changed.
    Change write(const CommandReader::RegisterWrite& write);

    // The values as they are; the same object until a register changes.
    std::shared_ptr<const Registers> snapshot();

private:
    Registers values_;
    std::shared_ptr<const Registers> snapshot_;
};

} // namespace ffgpu
