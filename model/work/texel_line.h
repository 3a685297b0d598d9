// Lines of texel caches by number. A line holds bytes of memory as they lie there, or texels that
// were expanded from compressed blocks: those lines are numbered in an address space in which each
// block has as many times its bytes as its texels take. The number tells which.

#pragma once

#include "model/base/powers_of_two.h"

#include <algorithm>
#include <cstdint>

namespace ffgpu::work {

inline constexpr std::uint32_t ExpandedTexelBytes = 4; // red, green, blue, alpha
inline constexpr std::uint32_t ExpandedBlockBytes = 16 * ExpandedTexelBytes;
inline constexpr unsigned ExpansionAt = 56; // bits of the number: log2 of the expansion

// The line of expanded byte `offset` of the block at `address`, expanded 2^log2 times.
constexpr std::uint64_t expanded_line(std::uint64_t address,
                                      unsigned log2,
                                      std::uint32_t offset,
                                      std::uint32_t line_bytes) {
    return std::uint64_t{log2} << ExpansionAt | quotient((address << log2) + offset, line_bytes);
}

constexpr unsigned expansion_of(std::uint64_t line) {
    return static_cast<unsigned>(line >> ExpansionAt);
}

// What memory holds of a line: whole blocks.
struct LineSource {
    std::uint64_t address = 0;
    std::uint32_t bytes = 0;
};

constexpr LineSource line_source(std::uint64_t line, std::uint32_t line_bytes) {
    const unsigned log2 = expansion_of(line);
    if (log2 == 0) return {line * line_bytes, line_bytes};
    const std::uint64_t number = line & ((std::uint64_t{1} << ExpansionAt) - 1);
    const std::uint32_t block = ExpandedBlockBytes >> log2;
    return {(number * line_bytes >> log2) / block * block, std::max(line_bytes >> log2, block)};
}

} // namespace ffgpu::work
