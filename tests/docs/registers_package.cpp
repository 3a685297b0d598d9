// rtl/ffgpu_registers_pkg.sv.

#include "tests/docs/register_list.h"

#include <cctype>
#include <cstdio>

namespace ffgpu::docs {
namespace {

const char* Head =
    R"(// Where each field of each register stands. Printed from the list in model/device/registers.h by
// the build target registers_page; not edited by hand. docs/registers.md says the same in a table.
//
// Of a register: its address (of the first where there are several in a row, then Count of them),
// its words and its packed reset value, word 0 lowest. Of a field: its word, least significant bit
// and width; Elements follow one another, a word each.
package ffgpu_registers_pkg;
)";

// fog_control -> FogControl, address_1 -> Address1
std::string pascal_case(const std::string& snake) {
    std::string text;
    bool upper = true;
    for (const char c : snake) {
        if (c != '_') text += upper ? static_cast<char>(std::toupper(c)) : c;
        upper = c == '_';
    }
    return text;
}

std::string constant(const std::string& name, unsigned value) {
    return "  localparam int unsigned " + name + " = " + std::to_string(value) + ";\n";
}

// Words as one number, the last one first; eight to a line.
std::string reset_constant(const std::string& name, const std::vector<std::uint32_t>& words) {
    std::string text = "  localparam logic [" + std::to_string(32 * words.size() - 1) + ":0] " +
                       name + "Reset = {";
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

} // namespace

std::string registers_package(const std::vector<RegisterEntry>& registers) {
    std::string package = Head;
    for (const RegisterEntry& reg : registers) {
        const std::string name = pascal_case(reg.name);
        package += "\n  // " + reg.name + "\n";
        package += constant(name + "Address", reg.address);
        if (reg.count > 1) package += constant(name + "Count", reg.count);
        package += constant(name + "Words", reg.words) + reset_constant(name, reg.reset);
        for (const FieldEntry& field : reg.fields) {
            const std::string base = name + pascal_case(field.name);
            package += constant(base + "Word", field.word);
            package += constant(base + "Lsb", field.lsb) + constant(base + "Width", field.width);
            if (field.elements() > 1) package += constant(base + "Elements", field.elements());
        }
    }
    return package + "\nendpackage\n";
}

} // namespace ffgpu::docs
