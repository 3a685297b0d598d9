// Images of r g b a bytes, rows without padding, to and from blocks of a compressed format: what
// the driver itself must compress or take apart. Applications' own blocks go to the device as they
// are.

#pragma once

#include "model/device/layout/formats.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ffgpu::gl {

struct BlockImageSize {
    std::uint32_t width, height;
    std::uint32_t depth = 1;
};

// Texels beyond the edge repeat the last ones.
std::vector<std::byte> compress(Format format, const std::byte* rgba, BlockImageSize size);
std::vector<std::byte> decompress(Format format, const std::byte* blocks, BlockImageSize size);

} // namespace ffgpu::gl
