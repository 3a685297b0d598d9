// An application's pixels as texels in a device format, and back (GL 1.5, 3.8.1 and 6.1.4).

#pragma once

#include "driver/pixel/pack.h"
#include "driver/pixel/unpack.h"
#include "driver/texel/internal_format.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ffgpu::gl {

// After pixel transfer; tightly packed. The kinds fit: colours for colour formats, depths for depth
// formats.
std::vector<std::byte>
unpack_texels(const PixelSource& source, const PixelState& transfer, InternalFormat format);

// Texels of an image, tightly packed, to the application; no pixel transfer.
void pack_texels(const PixelDestination& destination,
                 InternalFormat format,
                 const std::byte* texels);

// The common uploads, where a row of bytes only changes places. False: this is not one of them;
// nothing was done.
bool unpack_fast(const PixelSource& source, Format format, std::byte* texels);

} // namespace ffgpu::gl
