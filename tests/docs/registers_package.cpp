// rtl/ffgpu_registers_pkg.sv, and the module that its test reads it with.

#include "model/device/pipe_numbers.h"
#include "tests/docs/register_pages.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>

namespace ffgpu::docs {
namespace {

const char* const Head =
    R"(// The registers and commands as packed structs, with a function each that decodes its words.
// Printed from the list in model/device/registers.h by the build target registers_page; not edited
// by hand. docs/registers.md says where each field stands, model/device/registers/ what it means.
//
// Of a register: its address (of the first where there are several in a row, then Count of them),
// its words and its packed reset value, word 0 lowest. Of a command: its opcode, the words of its
// payload. Fields stand in the structs in the order of the list, arrays with element 0 lowest.
package ffgpu_registers_pkg;
)";

std::string upper_first(std::string text) {
    text[0] = static_cast<char>(std::toupper(text[0]));
    return text;
}

// fog_control -> FogControl
std::string pascal_case(const std::string& snake) {
    std::string text;
    bool upper = true;
    for (const char c : snake) {
        if (c != '_') text += upper ? static_cast<char>(std::toupper(c)) : c;
        upper = c == '_';
    }
    return text;
}

// FogMode -> fog_mode
std::string snake_case(const std::string& pascal) {
    std::string text;
    for (const char c : pascal) {
        if (std::isupper(c) && !text.empty()) text += '_';
        text += static_cast<char>(std::tolower(c));
    }
    return text;
}

std::string range(unsigned bits) {
    return bits == 1 ? std::string("logic")
                     : std::string("logic [") + std::to_string(bits - 1) + ":0]";
}

// A field's name may be a word of the language.
std::string member(const PackedEntry& packed, const FieldEntry& field) {
    const std::string name = unique_name(packed, field);
    const bool reserved = name == "end" || name == "output" || name == "primitive";
    return reserved ? name + '_' : name;
}

using EnumWidths = std::map<std::string, unsigned>;

EnumWidths find_widths(const std::vector<PackedEntry>& all) {
    EnumWidths widths;
    for (const PackedEntry& packed : all)
        for (const FieldEntry& field : packed.fields)
            widths[field.enumeration] = std::max(widths[field.enumeration], field.width);
    return widths;
}

std::string type(const FieldEntry& field, const EnumWidths& widths) {
    if (field.elements() > 1)
        return std::string("logic [") + std::to_string(field.elements() - 1) + ":0][31:0]";
    const bool is_enumeration = field.type == FieldEntry::Type::Enumeration;
    if (is_enumeration && widths.at(field.enumeration) == field.width)
        return snake_case(field.enumeration) + "_e";
    return range(field.width);
}

std::string enumeration(const EnumerationEntry& entry, unsigned width) {
    std::string text = std::string("  typedef enum ") + range(width) + " {\n";
    for (std::size_t i = 0; i < entry.values.size(); ++i) {
        text += "    " + entry.name + upper_first(entry.values[i]) + " = " + std::to_string(width) +
                "'d" + std::to_string(i);
        text += i + 1 < entry.values.size() ? ",\n" : "\n";
    }
    return text.append("  } ").append(snake_case(entry.name)).append("_e;\n\n");
}

std::string constant(const std::string& name, unsigned value) {
    return "  localparam int unsigned " + name + " = " + std::to_string(value) + ";\n";
}

// Words as one number, the last one first; six to a line.
std::string reset_constant(const std::string& name, const PackedEntry& packed) {
    const std::vector<std::uint32_t> words = reset_words(packed);
    std::string text =
        "  localparam " + packed.name + "_words_t " + pascal_case(name) + "Reset = {";
    for (std::size_t i = words.size(); i-- > 0;) {
        char word[16];
        std::snprintf(word, sizeof word, "32'h%08x", words[i]);
        const std::size_t printed = words.size() - 1 - i;
        if (printed % 6 == 0) text += "\n    ";
        text += word;
        if (i != 0) text += printed % 6 == 5 ? "," : ", ";
    }
    return text + "\n  };\n";
}

std::string struct_type(const PackedEntry& packed, const EnumWidths& widths) {
    std::size_t column = 0;
    for (const FieldEntry& field : packed.fields)
        column = std::max(column, type(field, widths).size());
    std::string text = "  typedef struct packed {\n";
    for (const FieldEntry& field : packed.fields) {
        std::string kind = type(field, widths);
        kind.resize(column, ' ');
        text += std::string("    ") + kind + ' ' + member(packed, field) + ";\n";
    }
    return text + "  } " + packed.name + "_t;\n";
}

std::string decode_function(const PackedEntry& packed) {
    std::string text = std::string("  function automatic ") + packed.name + "_t decode_" +
                       packed.name + "(\n    input " + packed.name +
                       "_words_t words\n  );\n    decode_" + packed.name + " = {\n";
    for (const FieldEntry& field : packed.fields) {
        const unsigned low = 32 * field.word + field.lsb;
        const unsigned high = low + field.elements() * field.width - 1;
        text.append("      words[").append(std::to_string(high));
        if (high != low) text.append(":").append(std::to_string(low));
        text += &field == &packed.fields.back() ? "]  // " : "],  // ";
        text += member(packed, field) + "\n";
    }
    return text + "    };\n  endfunction\n";
}

// Words, struct and function.
std::string packed_part(const PackedEntry& packed, const EnumWidths& widths) {
    const std::string words = pascal_case(packed.name) + "Words";
    return constant(words, packed.words) + "  typedef logic [32*" + words + "-1:0] " + packed.name +
           "_words_t;\n" + struct_type(packed, widths) + decode_function(packed);
}

// The commands as they are named here: a draw_command is told from other draws.
std::vector<PackedEntry> commands_with_payload(const Description& contract) {
    std::vector<PackedEntry> commands;
    for (PackedEntry command : contract.commands) {
        command.name += "_command";
        if (command.words > 0) commands.push_back(std::move(command));
    }
    return commands;
}

std::vector<PackedEntry> all_packed(const Description& contract) {
    std::vector<PackedEntry> all = contract.registers;
    for (PackedEntry& command : commands_with_payload(contract))
        all.push_back(std::move(command));
    return all;
}

// The lines of register_fields_module that read the fields of one register or command.
std::string field_cases(const PackedEntry& packed, unsigned number) {
    std::string cases;
    unsigned element = 0;
    for (const FieldEntry& field : packed.fields)
        for (unsigned i = 0; i < field.elements(); ++i) {
            cases.append("      {16'd").append(std::to_string(number)).append(", 16'd");
            cases.append(std::to_string(element++)).append("}: value_o = {");
            if (field.width < 32) cases.append(std::to_string(32 - field.width)).append("'d0, ");
            cases.append(packed.name).append(".").append(member(packed, field));
            if (field.elements() > 1) cases.append("[").append(std::to_string(i)).append("]");
            cases.append("};\n");
        }
    return cases;
}

std::string decoded_net(const PackedEntry& packed) {
    std::string net = "  ffgpu_registers_pkg::";
    net.append(packed.name).append("_t ").append(packed.name).append(";\n  assign ");
    net.append(packed.name).append(" =\n    ffgpu_registers_pkg::decode_").append(packed.name);
    return net.append("(words_i[").append(std::to_string(32 * packed.words - 1)).append(":0]);\n");
}

} // namespace

std::string registers_package(const Description& contract) {
    const EnumWidths widths = find_widths(all_packed(contract));
    std::string package = Head + std::string("\n");
    for (const EnumerationEntry& entry : contract.enumerations)
        package += enumeration(entry, widths.at(entry.name));
    package += "  // Opcodes: bits 31..24 of a command's first word.\n";
    package += constant("WriteRegisterOpcode", WriteRegisterOpcode);
    for (const PackedEntry& command : contract.commands)
        package += constant(pascal_case(command.name) + "Opcode", command.address);
    for (const PackedEntry& reg : contract.registers) {
        package += "\n  // " + reg.name + "\n";
        package += constant(pascal_case(reg.name) + "Address", reg.address);
        if (reg.count > 1) package += constant(pascal_case(reg.name) + "Count", reg.count);
        package += packed_part(reg, widths) + reset_constant(reg.name, reg);
    }
    for (const PackedEntry& command : commands_with_payload(contract))
        package += "\n  // " + command.name + "\n" + packed_part(command, widths);
    package += "\n  // The fragment pipe in numbers: model/device/pipe_numbers.h.\n";
    for (const PipeNumber& number : PipeNumbers)
        package += "  localparam int unsigned " + std::string(number.name) + " = " +
                   std::to_string(number.value) + ";  // " + std::string(number.meaning) + "\n";
    return package + "\nendpackage\n";
}

std::string register_fields_module(const Description& contract) {
    std::string nets, cases;
    unsigned number = 0;
    for (const PackedEntry& packed : all_packed(contract)) {
        nets += decoded_net(packed);
        cases += field_cases(packed, number++);
    }
    std::string text = "// Hands out field `field_i` of register or command `packed_i` of the "
                       "package, by its name.\n"
                       "// Printed by the build target registers_page; not edited by hand.\n"
                       "module register_fields (\n  input  logic [2047:0] words_i,\n"
                       "  input  logic [15:0] packed_i,\n  input  logic [15:0] field_i,\n"
                       "  output logic [31:0] value_o\n);\n";
    text.append(nets).append("  always_comb begin\n    unique case ({packed_i, field_i})\n");
    text.append(cases).append("      default: value_o = 32'd0;\n    endcase\n  end\n");
    return text.append("  logic unused_words;\n  assign unused_words = ^words_i;\nendmodule\n");
}

} // namespace ffgpu::docs
