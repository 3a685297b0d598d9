#include "tools/info/census_device.h"

#include "model/base/check.h"
#include "model/device/validate.h"

#include <cstring>

namespace ffgpu::tools {

std::byte* CensusDevice::memory(DeviceAddress at, std::size_t bytes) const {
    check(at <= MemoryBytes && bytes <= MemoryBytes - at, "an access outside device memory");
    return memory_.get() + at;
}

void CensusDevice::write_memory(DeviceAddress at, std::span<const std::byte> bytes) {
    if (!bytes.empty()) std::memcpy(memory(at, bytes.size()), bytes.data(), bytes.size());
    if (counts_) census_.upload(bytes.size());
}

void CensusDevice::read_memory(DeviceAddress at, std::span<std::byte> bytes) {
    if (!bytes.empty()) std::memcpy(bytes.data(), memory(at, bytes.size()), bytes.size());
}

void CensusDevice::submit(const CommandStream& commands) {
    for_each_command(commands.words, [this](const CommandReader& reader) {
        if (reader.opcode() == Opcode::WriteRegister)
            registers_.write(reader.register_write());
        else
            count(reader);
    });
}

// Of a damaged file a draw may be anything: the same rules hold as on the device that draws.
void CensusDevice::count(const CommandReader& reader) {
    const Registers& state = registers_.values();
    validate(state, MemoryBytes);
    switch (reader.opcode()) {
    case Opcode::Draw: {
        const auto command = reader.command<DrawCommand>();
        validate(command, state, MemoryBytes);
        return census_.draw(state, command);
    }
    case Opcode::DrawImage:
        validate(reader.command<DrawImageCommand>(), MemoryBytes);
        return census_.image(state);
    case Opcode::Clear:
        return census_.clear();
    case Opcode::CopyRectangle:
        return census_.copy();
    case Opcode::WriteRegister:
    case Opcode::ResetSampleCounter:
    case Opcode::StoreSampleCounter:
    case Opcode::EndFrame:
        return;
    }
    reader.unknown_opcode();
}

} // namespace ffgpu::tools
