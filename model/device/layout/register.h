// How a register becomes words.
//
// A register is a plain struct. Its member initialisers are its reset value; its visit() names
// each field once, with its width in bits, least significant first. Packing, unpacking, the debug
// dump, docs/registers.md and the SystemVerilog package all come from visit().
//
//     template <class Self, class Visitor> static constexpr void visit(Self& self, Visitor&& field)
//     {
//         field("enable", self.enable, 1);
//         field("reference", self.reference);      // a float: always one whole word
//     }
//
// Fields fill 32-bit words from bit 0; a field that does not fit begins the next word. A name may
// come again in a register (the elements of an array); name and count tell a field apart, which is
// what captures of other releases go by.

#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>

namespace ffgpu {

// "write_mask", or of a part of a register with a part's name: "front" and "write_mask".
struct FieldName {
    constexpr FieldName(const char* whole)
        : name(whole) {}

    const char* part = "";
    const char* name;

    std::string text() const { return *part ? std::string(part) + '_' + name : name; }
};

// A visitor of a part's fields: for structs that stand in a register more than once.
template <class Visitor>
constexpr auto in_part(const char* part, Visitor& field) {
    return [part, &field](FieldName name, auto& value, unsigned width = 32) {
        name.part = part;
        field(name, value, width);
    };
}

template <class Field>
constexpr std::uint32_t field_bits(const Field& field) {
    if constexpr (std::is_same_v<Field, float>) {
        return std::bit_cast<std::uint32_t>(field);
    } else {
        return static_cast<std::uint32_t>(field);
    }
}

// Calls place(name, field, word, lsb, width) for each field of `self`; returns the word count.
template <class Register, class Self, class Place>
constexpr unsigned visit_placed(Self& self, Place&& place) {
    unsigned bit = 0;
    const auto field = [&](FieldName name, auto& value, unsigned width = 32) {
        if (bit % 32 + width > 32) bit = (bit + 31) / 32 * 32;
        place(name, value, bit / 32, bit % 32, width);
        bit += width;
    };
    Register::visit(self, field);
    return (bit + 31) / 32;
}

template <class Register>
constexpr unsigned count_words() {
    Register reg{};
    return visit_placed<Register>(reg, [](FieldName, auto&, unsigned, unsigned, unsigned) {});
}

// Number of 32-bit words of a register.
template <class Register>
constexpr unsigned WordCount = count_words<Register>();

// `words` has WordCount<Register> elements.
template <class Register>
constexpr void pack(const Register& reg, std::span<std::uint32_t> words) {
    for (std::uint32_t& word : words)
        word = 0;
    visit_placed<Register>(
        reg, [&](FieldName, const auto& field, unsigned word, unsigned lsb, unsigned width) {
            const std::uint32_t mask = ~std::uint32_t{0} >> (32 - width);
            words[word] |= (field_bits(field) & mask) << lsb;
        });
}

template <class Register>
constexpr Register unpack(std::span<const std::uint32_t> words) {
    Register reg{};
    visit_placed<Register>(
        reg, [&](FieldName, auto& field, unsigned word, unsigned lsb, unsigned width) {
            using Field = std::remove_reference_t<decltype(field)>;
            const std::uint32_t mask = ~std::uint32_t{0} >> (32 - width);
            const std::uint32_t bits = (words[word] >> lsb) & mask;
            if constexpr (std::is_same_v<Field, float>) {
                field = std::bit_cast<float>(bits);
            } else if constexpr (std::is_signed_v<Field>) {
                const unsigned spare = 32 - width; // Sign extension.
                field = static_cast<Field>(static_cast<std::int32_t>(bits << spare) >> spare);
            } else {
                field = static_cast<Field>(bits);
            }
        });
    return reg;
}

} // namespace ffgpu
