#include "model/capture/translator.h"

#include "model/base/input_error.h"

#include <algorithm>
#include <array>

namespace ffgpu::capture {
namespace {

constexpr std::uint32_t mask(unsigned width) {
    return ~std::uint32_t{0} >> (32 - width);
}

constexpr std::int32_t sign_extended(std::uint32_t value, unsigned width) {
    const unsigned spare = 32 - width;
    return static_cast<std::int32_t>(value << spare) >> spare;
}

const PackedEntry* find_packed(const std::vector<PackedEntry>& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, &PackedEntry::name);
    return found == all.end() ? nullptr : &*found;
}

// The address of the index-th register of that name.
std::optional<std::uint32_t>
find_address(const std::vector<PackedEntry>& all, const std::string& name, unsigned index) {
    for (const PackedEntry& entry : all) {
        if (entry.name != name) continue;
        if (index < entry.count) return entry.address + index;
        index -= entry.count;
    }
    return std::nullopt;
}

std::vector<std::optional<std::uint32_t>> match_values(const std::vector<std::string>& from,
                                                       const std::vector<std::string>& to) {
    std::vector<std::optional<std::uint32_t>> places;
    for (const std::string& value : from) {
        const auto found = std::ranges::find(to, value);
        places.emplace_back();
        if (found != to.end()) places.back() = static_cast<std::uint32_t>(found - to.begin());
    }
    return places;
}

} // namespace

PackedTranslation::PackedTranslation(const Description& from,
                                     const PackedEntry& from_entry,
                                     const Description& to,
                                     const PackedEntry* to_entry)
    : words_(from_entry.words) {
    if (to_entry) reset_ = reset_words(*to_entry);
    for (const FieldEntry& entry : from_entry.fields)
        for (unsigned i = 0; i < entry.elements(); ++i) {
            Field field;
            field.name = from_entry.name + '.' + unique_name(from_entry, entry);
            field.type = entry.type;
            field.word = entry.word + i;
            field.lsb = entry.lsb;
            field.width = entry.width;
            field.reset = entry.resets[i];
            if (to_entry) place(field, *to_entry, entry, entry.index + i);
            if (entry.type == FieldEntry::Type::Enumeration) {
                field.value_names = find_enumeration(from, entry.enumeration)->values;
                const EnumerationEntry* const known = find_enumeration(to, entry.enumeration);
                field.to_values = match_values(field.value_names,
                                               known ? known->values : std::vector<std::string>{});
            }
            fields_.push_back(std::move(field));
        }
}

// Finds this release's field of that name and type, the index-th.
void PackedTranslation::place(Field& field,
                              const PackedEntry& to,
                              const FieldEntry& from,
                              unsigned index) {
    for (const FieldEntry& entry : to.fields) {
        if (entry.name != from.name || entry.type != from.type ||
            entry.enumeration != from.enumeration || index < entry.index ||
            index - entry.index >= entry.elements())
            continue;
        field.to_word = entry.word + index - entry.index;
        field.to_lsb = entry.lsb;
        field.to_width = entry.width;
    }
}

std::uint32_t PackedTranslation::convert(const Field& field, std::uint32_t value) {
    if (field.type == FieldEntry::Type::Enumeration) {
        if (value >= field.to_values.size())
            throw InputError(field.name + " holds no value of its kind");
        if (!field.to_values[value])
            throw InputError(field.name + " holds " + field.value_names[value] +
                             ", which this release does not have");
        value = *field.to_values[value];
    } else if (field.type == FieldEntry::Type::Signed) {
        const std::int32_t number = sign_extended(value, field.width);
        value = static_cast<std::uint32_t>(number) & mask(field.to_width);
        if (sign_extended(value, field.to_width) != number)
            throw InputError(field.name + " holds " + std::to_string(number) +
                             ", which is too large in this release");
    }
    if (value > mask(field.to_width))
        throw InputError(field.name + " holds " + std::to_string(value) +
                         ", which is too large in this release");
    return value;
}

void PackedTranslation::translate(std::span<const std::uint32_t> words,
                                  std::vector<std::uint32_t>& out) const {
    const std::size_t begin = out.size();
    out.insert(out.end(), reset_.begin(), reset_.end());
    for (const Field& field : fields_) {
        const std::uint32_t value = (words[field.word] >> field.lsb) & mask(field.width);
        const bool known = field.type != FieldEntry::Type::Enumeration ||
                           (value < field.to_values.size() && field.to_values[value].has_value());
        if (value == field.reset && (field.to_width == 0 || !known)) continue;
        if (field.to_width == 0) fail_unknown(field, value);
        std::uint32_t& word = out[begin + field.to_word];
        word &= ~(mask(field.to_width) << field.to_lsb);
        word |= convert(field, value) << field.to_lsb;
    }
}

void PackedTranslation::expect_reset(std::span<const std::uint32_t> words) const {
    for (const Field& field : fields_) {
        const std::uint32_t value = (words[field.word] >> field.lsb) & mask(field.width);
        if (value != field.reset) fail_unknown(field, value);
    }
}

void PackedTranslation::fail_unknown(const Field& field, std::uint32_t value) {
    throw InputError(field.name + " holds " + std::to_string(value) +
                     ", but this release has no such field");
}

Translator::Translator(const Description& from)
    : Translator(from, describe_contract()) {}

Translator::Translator(const Description& from, const Description& to)
    : identity_(from == to)
    , surface_(from, from.surface, to, &to.surface) {
    std::map<std::string, unsigned> seen; // registers of each name
    for (const PackedEntry& entry : from.registers) {
        for (unsigned i = 0; i < entry.count; ++i) {
            const unsigned index = seen[entry.name]++;
            registers_[entry.address + i] = {packed_.size(),
                                             find_address(to.registers, entry.name, index)};
        }
        packed_.emplace_back(from, entry, to, find_packed(to.registers, entry.name));
        resets_.push_back(reset_words(entry));
    }
    for (const PackedEntry& entry : from.commands) {
        const PackedEntry* const known = find_packed(to.commands, entry.name);
        CommandPlace place{packed_.size(), entry.name, {}};
        if (known) place.opcode = static_cast<Opcode>(known->address);
        commands_[entry.address] = place;
        packed_.emplace_back(from, entry, to, known);
        resets_.push_back(reset_words(entry));
    }
}

void Translator::add_resets(CommandStream& commands) const {
    CommandStream ours;
    const Registers registers;
    std::array<std::size_t, RegisterCount> at{};
    std::uint32_t address = 0;
    Registers::visit(registers, [&](const auto& reg) {
        at[address] = ours.words.size();
        ours.write(address++, reg);
    });
    for (const auto& [from_address, place] : registers_) {
        if (!place.address) continue;
        const std::size_t begin = commands.words.size();
        add_register(place, resets_[place.packed], commands);
        const std::span added = std::span(commands.words).subspan(begin);
        if (std::equal(added.begin(),
                       added.end(),
                       ours.words.begin() + static_cast<std::ptrdiff_t>(at[*place.address])))
            commands.words.resize(begin);
    }
}

void Translator::add_register(const RegisterPlace& place,
                              std::span<const std::uint32_t> words,
                              CommandStream& commands) const {
    const PackedTranslation& packed = packed_[place.packed];
    if (!place.address) return packed.expect_reset(words);
    commands.words.push_back(
        CommandStream::header(Opcode::WriteRegister, 1u + RegisterWords[*place.address]));
    commands.words.push_back(*place.address);
    packed.translate(words, commands.words);
}

void Translator::add(const CommandReader& reader, CommandStream& commands) const {
    const auto opcode = static_cast<unsigned>(reader.opcode());
    const auto payload = reader.payload();
    if (opcode == WriteRegisterOpcode) {
        if (payload.empty()) throw InputError("a register write without an address");
        const auto found = registers_.find(payload[0]);
        if (found == registers_.end())
            throw InputError("there is no register " + std::to_string(payload[0]));
        reader.expect(1 + packed_[found->second.packed].words());
        return add_register(found->second, payload.subspan(1), commands);
    }
    const auto found = commands_.find(opcode);
    if (found == commands_.end()) reader.unknown_opcode();
    const CommandPlace& place = found->second;
    const PackedTranslation& packed = packed_[place.packed];
    reader.expect(packed.words());
    if (!place.opcode) throw InputError("this release has no command " + place.name);
    const std::size_t begin = commands.words.size();
    commands.words.push_back(0);
    packed.translate(payload, commands.words);
    const std::size_t count = commands.words.size() - begin - 1;
    commands.words[begin] = CommandStream::header(*place.opcode, static_cast<std::uint32_t>(count));
}

Surface Translator::surface(std::span<const std::uint32_t> words) const {
    std::vector<std::uint32_t> translated;
    surface_.translate(words, translated);
    return unpack<Surface>(translated);
}

} // namespace ffgpu::capture
