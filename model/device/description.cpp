#include "model/device/description.h"

#include "model/device/commands.h"
#include "model/device/enumerators.h"

#include <algorithm>
#include <type_traits>

namespace ffgpu {
namespace {

static_assert(WriteRegisterOpcode == static_cast<unsigned>(Opcode::WriteRegister));

template <class Field>
constexpr FieldEntry::Type type_of() {
    if constexpr (std::is_same_v<Field, float>) return FieldEntry::Type::Float;
    if constexpr (std::is_enum_v<Field>) return FieldEntry::Type::Enumeration;
    if constexpr (std::is_signed_v<Field>) return FieldEntry::Type::Signed;
    return FieldEntry::Type::Unsigned;
}

bool continues(const FieldEntry& run, const FieldEntry& field) {
    return run.name == field.name && run.width == 32 && field.width == 32 &&
           field.word == run.word + run.elements();
}

unsigned count_fields(const PackedEntry& packed, const std::string& name) {
    unsigned count = 0;
    for (const FieldEntry& field : packed.fields)
        if (field.name == name) count += field.elements();
    return count;
}

template <class Enum>
void add_enumeration(Description& description) {
    EnumerationEntry entry{std::string(enumeration_name<Enum>()), {}};
    if (find_enumeration(description, entry.name)) return;
    for (std::size_t i = 0; i < EnumeratorCount<Enum>; ++i)
        entry.values.emplace_back(EnumeratorNames<Enum>[i]);
    description.enumerations.push_back(std::move(entry));
}

// One field, its enumeration added to the description.
template <class Field>
FieldEntry describe_field(std::string name, Description& description) {
    FieldEntry entry;
    entry.name = std::move(name);
    entry.type = type_of<Field>();
    if constexpr (std::is_enum_v<Field>) {
        add_enumeration<Field>(description);
        entry.enumeration = enumeration_name<Field>();
    }
    return entry;
}

template <class Packed>
PackedEntry describe(const Packed& packed, unsigned address, Description& description) {
    PackedEntry entry{.name = Packed::Name,
                      .address = address,
                      .count = 1,
                      .words = WordCount<Packed>,
                      .fields = {}};
    std::vector<std::uint32_t> reset(entry.words);
    pack(packed, std::span(reset));
    visit_placed<Packed>(
        packed,
        [&](FieldName name, const auto& value, unsigned word, unsigned lsb, unsigned width) {
            using Field = std::remove_cvref_t<decltype(value)>;
            FieldEntry field = describe_field<Field>(name.text(), description);
            field.index = count_fields(entry, field.name);
            field.word = word;
            field.lsb = lsb;
            field.width = width;
            field.resets = {(reset[word] >> lsb) & (~std::uint32_t{0} >> (32 - width))};
            if (!entry.fields.empty() && continues(entry.fields.back(), field)) {
                entry.fields.back().resets.push_back(field.resets[0]);
            } else {
                entry.fields.push_back(std::move(field));
            }
        });
    return entry;
}

} // namespace

Description describe_contract() {
    Description all;
    const Registers registers;
    unsigned address = 0;
    Registers::visit(registers, [&](const auto& reg) {
        PackedEntry entry = describe(reg, address++, all);
        if (!all.registers.empty() && all.registers.back().name == entry.name &&
            all.registers.back().fields == entry.fields) {
            ++all.registers.back().count;
        } else {
            all.registers.push_back(std::move(entry));
        }
    });
    visit_commands([&](const auto& command) {
        const auto opcode = static_cast<unsigned>(command.Code);
        all.commands.push_back(describe(command, opcode, all));
    });
    all.surface = describe(Surface{}, 0, all);
    return all;
}

const EnumerationEntry* find_enumeration(const Description& description, const std::string& name) {
    const auto& all = description.enumerations;
    const auto found = std::ranges::find(all, name, &EnumerationEntry::name);
    return found == all.end() ? nullptr : &*found;
}

std::vector<std::uint32_t> reset_words(const PackedEntry& packed) {
    std::vector<std::uint32_t> words(packed.words);
    for (const FieldEntry& field : packed.fields)
        for (unsigned i = 0; i < field.elements(); ++i)
            words[field.word + i] |= field.resets[i] << field.lsb;
    return words;
}

std::string unique_name(const PackedEntry& packed, const FieldEntry& field) {
    const auto entries = std::ranges::count(packed.fields, field.name, &FieldEntry::name);
    return entries == 1 ? field.name : field.name + '_' + std::to_string(field.index);
}

} // namespace ffgpu
