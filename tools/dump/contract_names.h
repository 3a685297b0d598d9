// ContractNames: commands and registers of the contract as text.

#pragma once

#include "model/device/command_reader.h"
#include "model/device/description.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ffgpu::tools {

class ContractNames {
public:
    ContractNames();

    // "draw: primitive Triangles, index_type U16, ..."; of a register write those of its fields
    // that change what the register held: "light[2]: enabled 1".
    std::string command(const CommandReader& reader);

    // "draw", "light[2]"
    std::string name(const CommandReader& reader) const;

private:
    struct Register {
        const PackedEntry* entry;
        unsigned number; // of several in a row
    };
    std::string field_value(const FieldEntry& field, std::uint32_t value) const;
    std::string fields(const PackedEntry& packed,
                       std::span<const std::uint32_t> words,
                       std::span<const std::uint32_t> before) const;
    const PackedEntry* command_entry(Opcode opcode) const;

    const Description contract_;
    std::vector<Register> registers_;                // by address
    std::vector<std::vector<std::uint32_t>> values_; // of the registers
};

} // namespace ffgpu::tools
