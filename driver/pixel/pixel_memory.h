// The memory behind a command's pixel pointer: the application's own, or a buffer object's from the
// offset that the pointer then is (ARB_pixel_buffer_object).

#pragma once

#include "driver/pixel/pack.h"
#include "driver/pixel/unpack.h"
#include "driver/state/buffer_state.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace ffgpu::gl {

class Context;

// Nothing: the bound buffer is mapped or too small; the error is recorded. The pointer may be null
// where no buffer is bound.
std::optional<const std::byte*>
source_memory(Context& context, const void* pixels, std::uint64_t bytes, unsigned alignment);
std::optional<std::byte*>
destination_memory(Context& context, void* pixels, std::uint64_t bytes, unsigned alignment);

// The application's pixels as its unpack parameters say; memory null: there are none. Nothing: the
// error is recorded.
std::optional<PixelSource> pixel_source(Context& context,
                                        const void* pixels,
                                        ImageSize size,
                                        GLenum format,
                                        GLenum type,
                                        bool three_d = false);
std::optional<PixelDestination> pixel_destination(Context& context,
                                                  void* pixels,
                                                  ImageSize size,
                                                  GLenum format,
                                                  GLenum type,
                                                  bool three_d = false);

// A copy of the pixels as they are now, stored as TightStore says, for a display list. Empty where
// there are none, or where the command will fail anyway. Errors of the memory are recorded.
std::vector<std::byte> capture_pixels(
    Context& context, const void* pixels, ImageSize size, GLenum format, GLenum type, bool three_d);

// While it lives, pixels are read from plain memory that is stored as TightStore says: what a
// display list captured.
class TightUnpackScope {
public:
    explicit TightUnpackScope(Context& context);
    ~TightUnpackScope();
    TightUnpackScope(const TightUnpackScope&) = delete;
    TightUnpackScope& operator=(const TightUnpackScope&) = delete;

private:
    Context& context_;
    PixelStore store_;
    std::shared_ptr<BufferObject> buffer_;
};

} // namespace ffgpu::gl
