// RecordingDevice: plain memory, the registers as written, and the other commands in order: what a
// test of the driver wants to know.

#pragma once

#include "model/base/check.h"
#include "model/device/command_reader.h"
#include "model/device/device.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace ffgpu {

class RecordingDevice final : public Device {
public:
    explicit RecordingDevice(std::size_t bytes = 4u << 20)
        : memory(bytes) {}

    struct Recorded {
        Opcode opcode;
        std::vector<std::uint32_t> payload;

        template <class Command>
        Command as() const {
            check(opcode == Command::Code, "another command was recorded");
            return unpack<Command>(payload);
        }
    };

    std::vector<std::byte> memory;
    Registers registers;
    std::vector<std::uint32_t> written; // addresses of the registers written
    std::vector<Recorded> commands;     // all but register writes
    unsigned finishes = 0;

    void forget() {
        written.clear();
        commands.clear();
    }

    std::uint64_t memory_size() const override { return memory.size(); }
    void write_memory(DeviceAddress at, std::span<const std::byte> bytes) override {
        check(at + bytes.size() <= memory.size(), "write beyond memory");
        std::copy(bytes.begin(), bytes.end(), memory.begin() + at);
    }
    void read_memory(DeviceAddress at, std::span<std::byte> bytes) override {
        check(at + bytes.size() <= memory.size(), "read beyond memory");
        std::copy_n(memory.begin() + at, bytes.size(), bytes.begin());
    }
    void submit(const CommandStream& stream) override {
        for_each_command(stream.words, [this](const CommandReader& reader) {
            const std::span payload = reader.payload();
            if (reader.opcode() == Opcode::WriteRegister) {
                write_register(reader.register_write());
            } else {
                commands.push_back({reader.opcode(), {payload.begin(), payload.end()}});
            }
        });
    }
    void finish() override { ++finishes; }
    std::vector<const StatisticsGroup*> statistics() const override { return {}; }

private:
    void write_register(const CommandReader::RegisterWrite& write) {
        written.push_back(write.address);
        std::uint32_t place = 0;
        Registers::visit(registers, [&](auto& reg) {
            if (place++ != write.address) return;
            reg = unpack<std::remove_cvref_t<decltype(reg)>>(write.words);
        });
    }
};

} // namespace ffgpu
