// log2_fixed8(): the base-2 logarithm with 8 fraction bits, from the exponent of a binary32 number
// and a table over the first 8 bits of its mantissa. Exact at powers of two, never decreasing.
//
//     log2_fixed8(x) = floor(256 log2(x')),   x' = x with its mantissa cut to 8 bits
//
// The table is squared into being, bit by bit, so that no library's logarithm takes part.

#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace ffgpu {

// floor(256 log2(1 + i / 256)): y = 1 + i/256 is squared; if it reaches 2, the next bit of the
// logarithm is 1 and y is halved. 31 fraction bits of y suffice: every entry is the true floor.
constexpr std::uint8_t log2_table_entry(unsigned i) {
    constexpr unsigned Fraction = 31;
    std::uint64_t y = (256u + std::uint64_t{i}) << (Fraction - 8);
    unsigned result = 0;
    for (unsigned bit = 0; bit < 8; ++bit) {
        y = y * y >> Fraction;
        const bool one = (y >> (Fraction + 1)) != 0;
        result = 2 * result + one;
        y >>= one;
    }
    return static_cast<std::uint8_t>(result);
}

// Three bytes more than the mantissas, so that 32 bits may be read from any entry on.
constexpr std::array<std::uint8_t, 256 + 3> make_log2_table() {
    std::array<std::uint8_t, 256 + 3> table{};
    for (unsigned i = 0; i < 256; ++i)
        table[i] = log2_table_entry(i);
    return table;
}

inline constexpr std::array<std::uint8_t, 256 + 3> Log2Table = make_log2_table();

// Of |x|. Zero and subnormals count as 2^-127 (their exponent field), infinity and NaN as 2^128 or
// a little more: the exponent field rules, no special case. Result within [-127 * 256, 129 * 256).
constexpr std::int32_t log2_fixed8_bits(std::uint32_t binary32) {
    const auto exponent = static_cast<std::int32_t>(binary32 >> 23 & 0xff) - 127;
    return exponent * 256 + Log2Table[binary32 >> 15 & 0xff];
}

constexpr std::int32_t log2_fixed8(float x) {
    return log2_fixed8_bits(std::bit_cast<std::uint32_t>(x));
}

} // namespace ffgpu
