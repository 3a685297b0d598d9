// The register map as data, from Registers::visit: what docs/registers.md and the SystemVerilog
// package are printed from.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu::docs {

// Fields of one name that follow one another, a word each, are one entry: a matrix is 16 words.
struct FieldEntry {
    enum class Type { Unsigned, Signed, Float };

    std::string name; // A name that comes again later in the register is numbered: address_1.
    Type type = Type::Unsigned;
    unsigned word = 0; // in the register; of the first element
    unsigned lsb = 0;
    unsigned width = 0;                // bits of one element
    std::vector<std::uint32_t> resets; // one an element

    unsigned elements() const { return static_cast<unsigned>(resets.size()); }
};

struct RegisterEntry {
    std::string name;
    unsigned address = 0; // of the first
    unsigned count = 0;   // at addresses in a row: one a light, one a texture unit
    unsigned words = 0;
    std::vector<FieldEntry> fields;
    std::vector<std::uint32_t> reset; // the packed register
};

std::vector<RegisterEntry> list_registers();

// The two files, whole.
std::string registers_page(const std::vector<RegisterEntry>& registers);
std::string registers_package(const std::vector<RegisterEntry>& registers);

} // namespace ffgpu::docs
