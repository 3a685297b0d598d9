// Packed structs of the RTL as C++ structs: one list of fields, `visit(self, field)`, first field
// highest, each called as field(name, value, width). Registers of the model are such structs too.

#pragma once

#include "model/device/layout/register.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

namespace ffgpu::rtl {

// A unit without registers.
struct NoState {
    template <class Self, class Visitor>
    static void visit(Self&, Visitor&&) {}
};

// A register of the model as the words that the RTL decodes.
template <class Field, class Register>
void visit_register(Field& field, const char* name, const Register& reg) {
    std::array<std::uint32_t, WordCount<Register>> words{};
    pack(reg, words);
    for (std::size_t i = words.size(); i-- > 0;)
        field(name, words[i], 32);
}
template <class Field, class Register>
void visit_register(Field& field, const char* name, Register& reg) {
    std::array<std::uint32_t, WordCount<Register>> words{};
    pack(std::as_const(reg), words);
    for (std::size_t i = words.size(); i-- > 0;)
        field(name, words[i], 32);
    reg = unpack<Register>(words);
}

// A member with a value a lane: lane 0 stands lowest.
template <class Field, class Value, std::size_t Count>
void visit_lanes(Field& field, const char* name, std::array<Value, Count>& values, unsigned width) {
    for (std::size_t lane = Count; lane-- > 0;)
        field(name, values[lane], width);
}
template <class Field, class Value, std::size_t Count>
void visit_lanes(Field& field,
                 const char* name,
                 const std::array<Value, Count>& values,
                 unsigned width) {
    for (std::size_t lane = Count; lane-- > 0;)
        field(name, values[lane], width);
}

template <class Packed>
unsigned bits_of() {
    static const unsigned Bits = [] {
        unsigned bits = 0;
        const auto add = [&](FieldName, const auto&, unsigned width = 32) { bits += width; };
        const Packed packed{};
        Packed::visit(packed, add);
        return bits;
    }();
    return Bits;
}

// As Verilator holds a wide port; the longest that a unit has.
constexpr std::size_t MaxWords = 80;

struct Bits {
    unsigned count = 0;
    std::array<std::uint32_t, MaxWords> words{};

    unsigned word_count() const { return (count + 31) / 32; }
    bool operator==(const Bits& other) const {
        for (unsigned i = 0; i < word_count(); ++i)
            if (words[i] != other.words[i]) return false;
        return count == other.count;
    }
};

inline void put(Bits& bits, unsigned at, unsigned width, std::uint64_t value) {
    for (unsigned done = 0; done < width;) {
        const unsigned shift = (at + done) % 32, take = std::min(32 - shift, width - done);
        const std::uint32_t mask = take == 32 ? ~0u : (1u << take) - 1;
        std::uint32_t& word = bits.words[(at + done) / 32];
        const auto part = static_cast<std::uint32_t>(value >> done) & mask;
        word = (word & ~(mask << shift)) | part << shift;
        done += take;
    }
}

inline std::uint64_t take(const Bits& bits, unsigned at, unsigned width) {
    std::uint64_t value = 0;
    for (unsigned done = 0; done < width;) {
        const unsigned shift = (at + done) % 32, count = std::min(32 - shift, width - done);
        const std::uint64_t mask = (std::uint64_t{1} << count) - 1;
        value |= (bits.words[(at + done) / 32] >> shift & mask) << done;
        done += count;
    }
    return value;
}

template <class Field>
std::uint64_t raw_bits(const Field& value) {
    if constexpr (std::is_same_v<Field, float>) {
        return field_bits(value);
    } else {
        return static_cast<std::uint64_t>(value);
    }
}

template <class Packed>
Bits to_bits(const Packed& packed) {
    Bits bits{.count = bits_of<Packed>()};
    unsigned at = bits.count;
    const auto add = [&](FieldName, const auto& value, unsigned width = 32) {
        put(bits, at -= width, width, raw_bits(value));
    };
    Packed::visit(packed, add);
    return bits;
}

// A field of floats or enumerations is set by its bits.
template <class Packed>
Packed from_bits(const Bits& bits) {
    Packed packed{};
    unsigned at = bits_of<Packed>();
    const auto read = [&](FieldName, auto& value, unsigned width = 32) {
        using Value = std::remove_reference_t<decltype(value)>;
        const std::uint64_t raw = take(bits, at -= width, width);
        if constexpr (std::is_same_v<Value, float>) {
            value = std::bit_cast<float>(static_cast<std::uint32_t>(raw));
        } else if constexpr (std::is_signed_v<Value>) {
            value =
                static_cast<Value>(static_cast<std::int64_t>(raw << (64 - width)) >> (64 - width));
        } else {
            value = static_cast<Value>(raw);
        }
    };
    Packed::visit(packed, read);
    return packed;
}

inline std::string to_hex(const Bits& bits) {
    std::string text;
    for (unsigned i = bits.word_count(); i-- > 0;)
        text += fmt::format("{:08x}", bits.words[i]);
    return text;
}

inline Bits bits_from_hex(unsigned count, const std::string& text) {
    Bits bits{.count = count};
    for (unsigned i = 0; i < bits.word_count() && 8 * (i + 1) <= text.size(); ++i)
        bits.words[i] = static_cast<std::uint32_t>(
            std::stoul(text.substr(text.size() - 8 * (i + 1), 8), nullptr, 16));
    return bits;
}

// The fields in which two differ, by name.
template <class Packed>
std::string differences(const Bits& expected, const Bits& got) {
    std::string text;
    unsigned at = bits_of<Packed>();
    const Packed packed{};
    const auto tell = [&](FieldName name, const auto&, unsigned width = 32) {
        at -= width;
        const std::uint64_t a = take(expected, at, width), b = take(got, at, width);
        if (a != b) text += fmt::format("    {}: expected {:#x}, got {:#x}\n", name.text(), a, b);
    };
    Packed::visit(packed, tell);
    return text;
}

} // namespace ffgpu::rtl
