// docs/registers.md.

#include "tests/docs/register_pages.h"

#include <algorithm>
#include <bit>
#include <cstdio>
#include <initializer_list>

namespace ffgpu::docs {
namespace {

const char* const Head = R"(# Registers

Printed from the list in `model/device/registers.h` by `cmake --build build --target registers_page`; not edited
by hand. A test fails where this page or `rtl/ffgpu_registers_pkg.sv` differs from the list.

A register is written whole, by the command `WriteRegister` with its address and its words
(`model/device/commands.h`); the address is its place in the list. Fields fill words from bit 0; one that does
not fit begins the next word. What a field means stands beside it in `model/device/registers/`.

- Types: `u` unsigned, `s` signed (two's complement), `f32` IEEE binary32, or the name of an enumeration: they are listed
  at the end, with their values from 0 on.
- `[n]`: n elements, a word each. A name that comes more than once in a register is numbered: in `vertex_format` the
  number is that of the `Attribute`, and of `current_attributes` the elements 4 n to 4 n + 3 are attribute n.
)";

std::string number(std::uint32_t bits, const FieldEntry& field) {
    char text[32];
    if (field.type == FieldEntry::Type::Float) {
        std::snprintf(text, sizeof text, "%g", static_cast<double>(std::bit_cast<float>(bits)));
    } else if (field.type == FieldEntry::Type::Signed) {
        const unsigned spare = 32 - field.width;
        std::snprintf(text, sizeof text, "%d", static_cast<std::int32_t>(bits << spare) >> spare);
    } else {
        std::snprintf(text, sizeof text, bits > 65535 ? "0x%x" : "%u", bits);
    }
    return text;
}

std::string reset_text(const FieldEntry& field) {
    const auto& all = field.resets;
    const bool alike =
        std::all_of(all.begin(), all.end(), [&](std::uint32_t bits) { return bits == all[0]; });
    if (alike) return number(all[0], field).append(all.size() > 1 ? " each" : "");
    std::string text;
    for (const std::uint32_t bits : all)
        text.append(text.empty() ? "" : " ").append(number(bits, field));
    return text;
}

std::string range(unsigned first, unsigned last, const char* between) {
    std::string text = std::to_string(first);
    if (first != last) text.append(between).append(std::to_string(last));
    return text;
}

std::string type_text(const FieldEntry& field) {
    std::string text = "f32";
    if (field.type == FieldEntry::Type::Enumeration) {
        text = field.enumeration;
    } else if (field.type != FieldEntry::Type::Float) {
        text = field.type == FieldEntry::Type::Signed ? 's' : 'u';
        text.append(std::to_string(field.width));
    }
    if (field.elements() > 1) text.append("[").append(std::to_string(field.elements())).append("]");
    return text;
}

std::string row(std::initializer_list<std::string> cells) {
    std::string text = "|";
    for (const std::string& cell : cells)
        text.append(" ").append(cell).append(" |");
    return text.append("\n");
}

std::string quoted(const std::string& name) {
    return std::string("`").append(name).append("`");
}

std::string field_row(const PackedEntry& reg, const FieldEntry& field) {
    const unsigned msb = field.lsb + field.width - 1;
    std::string bits = std::to_string(msb);
    if (msb != field.lsb) bits.append(":").append(std::to_string(field.lsb));
    return row({quoted(unique_name(reg, field)),
                range(field.word, field.word + field.elements() - 1, ".."),
                bits,
                type_text(field),
                reset_text(field)});
}

std::string enumeration_rows(const Description& contract) {
    std::string rows = "\n## Enumerations\n\n| enumeration | values from 0 on |\n|---|---|\n";
    for (const EnumerationEntry& entry : contract.enumerations) {
        std::string values;
        for (const std::string& value : entry.values)
            values.append(values.empty() ? "" : " ").append(value);
        rows += row({quoted(entry.name), values});
    }
    return rows;
}

} // namespace

std::string registers_page(const Description& contract) {
    std::string page = Head;
    page += "\n| address | register | words |\n|---|---|---|\n";
    for (const PackedEntry& reg : contract.registers) {
        const std::string link =
            std::string("[").append(reg.name).append("](#").append(reg.name).append(")");
        page += row({range(reg.address, reg.address + reg.count - 1, ".."),
                     link,
                     std::to_string(reg.words)});
    }
    for (const PackedEntry& reg : contract.registers) {
        page.append("\n## ").append(reg.name).append(
            "\n\n| field | word | bits | type | reset |\n");
        page += "|---|---|---|---|---|\n";
        for (const FieldEntry& field : reg.fields)
            page += field_row(reg, field);
    }
    return page + enumeration_rows(contract);
}

} // namespace ffgpu::docs
