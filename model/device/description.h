// The contract as data: registers, commands and enumerations with the names, places and widths of
// their fields, from the visit() functions. docs/registers.md and the SystemVerilog package are
// printed from it, and captures begin with it.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ffgpu {

struct EnumerationEntry {
    std::string name;
    std::vector<std::string> values; // from 0 on

    bool operator==(const EnumerationEntry&) const = default;
};

// Fields of one name that follow one another, a word each, are one entry: a matrix is 16 words.
struct FieldEntry {
    enum class Type : std::uint8_t { Unsigned, Signed, Float, Enumeration };

    std::string name;
    unsigned index = 0; // how many fields of that name come before it in the register
    Type type = Type::Unsigned;
    std::string enumeration; // the name of one, of Type::Enumeration
    unsigned word = 0;       // in the register; of the first element
    unsigned lsb = 0;
    unsigned width = 0;                // bits of one element
    std::vector<std::uint32_t> resets; // one an element

    unsigned elements() const { return static_cast<unsigned>(resets.size()); }
    bool operator==(const FieldEntry&) const = default;
};

// A register; a command's payload; a surface, as captures hold one.
struct PackedEntry {
    std::string name;
    unsigned address = 0; // of the first register; a command's opcode
    unsigned count = 0;   // registers at addresses in a row: one a light, one a texture unit
    unsigned words = 0;
    std::vector<FieldEntry> fields;

    bool operator==(const PackedEntry&) const = default;
};

struct Description {
    std::vector<EnumerationEntry> enumerations;
    std::vector<PackedEntry> registers;
    std::vector<PackedEntry> commands; // WriteRegister is not among them
    PackedEntry surface;

    bool operator==(const Description&) const = default;
};

// Of this release.
Description describe_contract();

// The opcode of register writes: the one command that is the same in every release.
constexpr unsigned WriteRegisterOpcode = 1;

// Null: there is none of that name.
const EnumerationEntry* find_enumeration(const Description& description, const std::string& name);

// The packed reset values.
std::vector<std::uint32_t> reset_words(const PackedEntry& packed);

// The field's name within its register: numbered where it comes more than once.
std::string unique_name(const PackedEntry& packed, const FieldEntry& field);

} // namespace ffgpu
