// exp2_negative(): 2^-x for x >= 0 in fixed point, from a table of 64 chords over one octave.
//
// x is U.16. Its integer part i becomes a shift; the upper 6 bits of its fraction choose a chord,
// the lower 10 interpolate on it:
//
//     2^-x = m 2^-17 2^-i,   m = base[k] - round(slope[k] low / 2^10),   2^16 <= m <= 2^17
//
// base[k] = round(2^17 2^(-k/64)), slope[k] = base[k] - base[k + 1]. m is within 3 units of
// 2^17 2^-fraction, is exact at the octave's ends, and never increases with x.

#pragma once

#include <array>
#include <cstdint>

namespace ffgpu {

constexpr unsigned Exp2TableBits = 6;
constexpr unsigned Exp2ChordBits = 16 - Exp2TableBits; // of the fraction, along a chord
constexpr unsigned Exp2MantissaBits = 17;
constexpr unsigned Exp2SlopeBits = 12;

// One word a chord: base << Exp2SlopeBits | slope.
constexpr std::array<std::uint32_t, 1u << Exp2TableBits> make_exp2_table() {
    constexpr double Step = 0.98922801319397548; // 2^(-1/64)
    std::array<std::uint32_t, 1u << Exp2TableBits> table{};
    double value = 1u << Exp2MantissaBits;
    for (std::uint32_t& entry : table) {
        const auto base = static_cast<std::uint32_t>(value + 0.5);
        value *= Step;
        entry = base << Exp2SlopeBits | (base - static_cast<std::uint32_t>(value + 0.5));
    }
    return table;
}

inline constexpr std::array<std::uint32_t, 1u << Exp2TableBits> Exp2Table = make_exp2_table();

// m for the 16 bits of a fraction.
constexpr std::uint32_t exp2_negative_mantissa(std::uint32_t fraction) {
    const std::uint32_t entry = Exp2Table[fraction >> Exp2ChordBits];
    const std::uint32_t low = fraction & ((1u << Exp2ChordBits) - 1);
    const std::uint32_t slope = entry & ((1u << Exp2SlopeBits) - 1);
    const std::uint32_t drop = (slope * low + (1u << (Exp2ChordBits - 1))) >> Exp2ChordBits;
    return (entry >> Exp2SlopeBits) - drop;
}

// round(255 2^-x), x in U4.16 and below 12: what a fog factor is made from.
constexpr std::uint32_t exp2_negative_unorm8(std::uint32_t x) {
    const std::uint32_t shift = Exp2MantissaBits + (x >> 16);
    return (255 * exp2_negative_mantissa(x & 0xffff) + (1u << (shift - 1))) >> shift;
}

} // namespace ffgpu
