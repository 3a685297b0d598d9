// Generated mip maps (GL 1.5, 3.8.8; EXT_framebuffer_object's glGenerateMipmap).

#pragma once

#include "driver/texture/residency.h"

namespace ffgpu::gl {

// Replaces the levels after the base level, down to one texel or the maximum level, of one face.
// Each texel is the mean of the part of the level above that it covers: of four texels, where sizes
// are powers of two. Means of sRGB images are means of light, their alpha's of the stored values.
void generate_mipmaps(DeviceMemory memory, TextureObject& texture, unsigned face);

// Texels of the next smaller level, of an uncompressed format; sizes include the border, whose
// texels are filtered along it.
std::vector<std::byte>
halve_image(const TextureLevel& from, const TextureLevel& to, const std::vector<std::byte>& texels);

} // namespace ffgpu::gl
