// The code of one sample's depths of a block (block_code.h).

#pragma once

#include "model/work/bit_string.h"

#include <cstdint>
#include <span>

namespace ffgpu::work {

struct DepthGrid {
    std::uint32_t width = 4, height = 4;
    unsigned bits = 24; // of a depth
};

enum class DepthMode : std::uint8_t { Uniform, Plane, TwoPlanes, Raw };
inline constexpr unsigned DepthModeBits = 2;
inline constexpr unsigned ResidualWidthBits = 5;

// Row after row.
void encode_depths(const DepthGrid& grid, std::span<const std::uint32_t> depths, BitWriter& out);
void decode_depths(const DepthGrid& grid, BitReader& in, std::span<std::uint32_t> depths);

} // namespace ffgpu::work
