// Moves texels between the host and device memory: the only place that knows where they are.

#pragma once

#include "driver/objects/texture_object.h"
#include "model/device/device.h"
#include "model/device/registers/fragment.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace ffgpu::gl {

struct DeviceMemory {
    Device& device;
    const std::shared_ptr<MemoryAllocator>& allocator;
};

// One image of a texture.
struct ImageName {
    unsigned face = 0;
    unsigned level = 0;
};

// A part of an image in stored texels, the border included: (0, 0, 0) is the first stored texel.
// Of compressed formats it begins at a block and ends at one or at the image's edge.
struct TexelBox {
    std::uint32_t x = 0, y = 0, z = 0;
    std::uint32_t width = 0, height = 0, depth = 0;
};

// Bytes of a part's texels, tightly packed.
std::size_t box_bytes(Format format, const TexelBox& box);
TexelBox whole_box(const TextureLevel& image);

// Gives an image its size, format and texels (`texels` holds box_bytes(whole) bytes, or none: the
// contents are undefined). Where size and format stay, memory does.
void define_image(DeviceMemory memory,
                  TextureObject& texture,
                  ImageName name,
                  TextureLevel definition,
                  std::vector<std::byte> texels);

// Texels of a part, tightly packed.
void write_texels(DeviceMemory memory,
                  TextureObject& texture,
                  ImageName name,
                  const TexelBox& box,
                  std::span<const std::byte> texels);
std::vector<std::byte>
read_texels(DeviceMemory memory, const TextureObject& texture, ImageName name, const TexelBox& box);

// Brings all levels of the texture's chain into device memory. False: there is no room.
bool make_resident(DeviceMemory memory, TextureObject& texture);

// Any image of uncompressed colours or depth as memory to copy to: in the chain, or, where it does
// not fit there, in memory of its own. Its border is part of the surface. Format None: no room.
Surface image_memory(DeviceMemory memory, TextureObject& texture, ImageName name, unsigned layer);

// The same as a target of drawing: Format None as well where the device cannot draw to it.
Surface image_surface(DeviceMemory memory, TextureObject& texture, ImageName name, unsigned layer);

} // namespace ffgpu::gl
