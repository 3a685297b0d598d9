#include "tests/docs/register_list.h"

#include "model/device/registers.h"

#include <algorithm>
#include <map>
#include <type_traits>

namespace ffgpu::docs {
namespace {

template <class Field>
constexpr FieldEntry::Type type_of() {
    if constexpr (std::is_same_v<Field, float>) return FieldEntry::Type::Float;
    if constexpr (std::is_signed_v<Field>) return FieldEntry::Type::Signed;
    return FieldEntry::Type::Unsigned;
}

bool continues(const FieldEntry& run, const FieldEntry& field) {
    return run.name == field.name && run.width == 32 && field.width == 32 &&
           field.word == run.word + run.elements();
}

// name, name, other -> name_0, name_1, other
void number_repeated_names(std::vector<FieldEntry>& fields) {
    std::map<std::string, unsigned> total, seen;
    for (const FieldEntry& field : fields)
        ++total[field.name];
    for (FieldEntry& field : fields) {
        const std::string name = field.name;
        if (total[name] == 1) continue;
        field.name += '_';
        field.name += std::to_string(seen[name]++);
    }
}

template <class Register>
RegisterEntry describe(const Register& reg, unsigned address) {
    RegisterEntry entry{.name = Register::Name,
                        .address = address,
                        .count = 1,
                        .words = WordCount<Register>,
                        .fields = {},
                        .reset = std::vector<std::uint32_t>(WordCount<Register>)};
    pack(reg, std::span(entry.reset));
    visit_placed<Register>(
        reg, [&](const char* name, const auto& value, unsigned word, unsigned lsb, unsigned width) {
            using Field = std::remove_cvref_t<decltype(value)>;
            const std::uint32_t mask = ~std::uint32_t{0} >> (32 - width);
            const std::uint32_t reset = (entry.reset[word] >> lsb) & mask;
            const FieldEntry field{name, type_of<Field>(), word, lsb, width, {reset}};
            if (!entry.fields.empty() && continues(entry.fields.back(), field)) {
                entry.fields.back().resets.push_back(reset);
            } else {
                entry.fields.push_back(field);
            }
        });
    number_repeated_names(entry.fields);
    return entry;
}

} // namespace

std::vector<RegisterEntry> list_registers() {
    std::vector<RegisterEntry> all;
    const Registers registers;
    unsigned address = 0;
    Registers::visit(registers, [&](const auto& reg) {
        const RegisterEntry entry = describe(reg, address++);
        if (!all.empty() && all.back().name == entry.name && all.back().reset == entry.reset) {
            ++all.back().count;
        } else {
            all.push_back(entry);
        }
    });
    return all;
}

} // namespace ffgpu::docs
