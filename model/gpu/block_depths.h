// What a depth target holds in a block of 8x8 pixels.

#pragma once

#include "model/device/registers/fragment.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

// The greatest depth, in units of the target, of the block whose lower left pixel is (x, y). It
// lies on the target, Depth16 or Depth24Stencil8, as a whole.
std::uint32_t
farthest_depth(const Surface& target, unsigned x, unsigned y, std::span<const std::byte> memory);

// The same, pixel by pixel: the specification.
std::uint32_t farthest_depth_scalar(const Surface& target,
                                    unsigned x,
                                    unsigned y,
                                    std::span<const std::byte> memory);

// Of the rows of a block, `stride` bytes apart.
using FarthestInRows = std::uint32_t (*)(const std::byte* first, std::size_t stride, Format format);

// The form for the instruction set that Highway chooses now.
FarthestInRows choose_farthest_in_rows();

} // namespace ffgpu
