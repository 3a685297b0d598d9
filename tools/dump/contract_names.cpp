#include "tools/dump/contract_names.h"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

namespace ffgpu::tools {

ContractNames::ContractNames()
    : contract_(describe_contract()) {
    for (const PackedEntry& entry : contract_.registers)
        for (unsigned i = 0; i < entry.count; ++i) {
            registers_.push_back({&entry, i});
            values_.push_back(reset_words(entry));
        }
}

std::string ContractNames::name(const CommandReader& reader) const {
    if (reader.opcode() != Opcode::WriteRegister) {
        const PackedEntry* const entry = command_entry(reader.opcode());
        return entry ? entry->name : fmt::format("opcode {}", static_cast<int>(reader.opcode()));
    }
    const Register& place = registers_[reader.register_write().address];
    return place.entry->count == 1 ? place.entry->name
                                   : fmt::format("{}[{}]", place.entry->name, place.number);
}

std::string ContractNames::command(const CommandReader& reader) {
    std::string text;
    if (reader.opcode() == Opcode::WriteRegister) {
        const CommandReader::RegisterWrite write = reader.register_write();
        std::vector<std::uint32_t>& value = values_[write.address];
        text = fields(*registers_[write.address].entry, write.words, value);
        value.assign(write.words.begin(), write.words.end());
        if (text.empty()) text = "as before";
    } else if (const PackedEntry* const entry = command_entry(reader.opcode())) {
        reader.expect(entry->words);
        text = fields(*entry, reader.payload(), {});
    }
    return name(reader) + (text.empty() ? "" : ": " + text);
}

const PackedEntry* ContractNames::command_entry(Opcode opcode) const {
    const auto found =
        std::ranges::find(contract_.commands, static_cast<unsigned>(opcode), &PackedEntry::address);
    return found == contract_.commands.end() ? nullptr : &*found;
}

// All fields, or those that differ from `before`.
std::string ContractNames::fields(const PackedEntry& packed,
                                  std::span<const std::uint32_t> words,
                                  std::span<const std::uint32_t> before) const {
    std::string text;
    for (const FieldEntry& field : packed.fields) {
        const auto value_in = [&](std::span<const std::uint32_t> from, unsigned element) {
            return from[field.word + element] >> field.lsb &
                   ~std::uint32_t{0} >> (32 - field.width);
        };
        std::string values;
        bool changes = before.empty();
        for (unsigned i = 0; i < field.elements(); ++i) {
            changes = changes || value_in(words, i) != value_in(before, i);
            values += ' ' + field_value(field, value_in(words, i));
        }
        if (changes) text += (text.empty() ? "" : ", ") + unique_name(packed, field) + values;
    }
    return text;
}

std::string ContractNames::field_value(const FieldEntry& field, std::uint32_t value) const {
    switch (field.type) {
    case FieldEntry::Type::Float:
        return fmt::format("{}", std::bit_cast<float>(value)); // As short as reads back the same.
    case FieldEntry::Type::Signed: {
        const unsigned unused = 32 - field.width;
        return std::to_string(static_cast<std::int32_t>(value << unused) >> unused);
    }
    case FieldEntry::Type::Enumeration: {
        const EnumerationEntry* const names = find_enumeration(contract_, field.enumeration);
        if (names && value < names->values.size()) return names->values[value];
        return std::to_string(value);
    }
    case FieldEntry::Type::Unsigned:
        break;
    }
    const bool is_address = field.name == "address" || field.name.ends_with("_address");
    return is_address ? fmt::format("{:#010x}", value) : std::to_string(value);
}

} // namespace ffgpu::tools
