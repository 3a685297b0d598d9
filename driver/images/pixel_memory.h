// The memory behind a command's pixel pointer: the application's own, or a buffer object's from the
// offset that the pointer then is (ARB_pixel_buffer_object).

#pragma once

#include "driver/pixel/pack.h"
#include "driver/pixel/unpack.h"

#include <cstddef>
#include <optional>

namespace ffgpu::gl {

class DeviceContext;

// Nothing: the bound buffer is mapped or too small; the error is recorded. The pointer may be null
// where no buffer is bound.
std::optional<const std::byte*>
source_memory(DeviceContext& context, const void* pixels, std::uint64_t bytes, unsigned alignment);
std::optional<std::byte*>
destination_memory(DeviceContext& context, void* pixels, std::uint64_t bytes, unsigned alignment);

// The application's pixels as its unpack parameters say; memory null: there are none. Nothing: the
// error is recorded.
std::optional<PixelSource> pixel_source(DeviceContext& context,
                                        const void* pixels,
                                        ImageSize size,
                                        GLenum format,
                                        GLenum type,
                                        bool three_d = false);
std::optional<PixelDestination> pixel_destination(DeviceContext& context,
                                                  void* pixels,
                                                  ImageSize size,
                                                  GLenum format,
                                                  GLenum type,
                                                  bool three_d = false);

} // namespace ffgpu::gl
