// Drawable: the surfaces of a window, pixmap or off-screen buffer: front and back colour, depth and
// stencil, accumulation. They live in device memory; row 0 is the lowest.

#pragma once

#include "driver/memory_allocator.h"
#include "model/device/device.h"

#include <cstdint>
#include <vector>

namespace ffgpu::gl {

// What a GLX visual, an EGL config or a test asks for.
struct PixelFormat {
    bool double_buffer = true;
    bool alpha = true;
    std::uint8_t depth_bits = 24;  // 0, 16 or 24
    std::uint8_t stencil_bits = 8; // 0 or 8; 8 goes with 24 depth bits
    bool accumulation = true;      // 16 bits signed a channel

    bool operator==(const PixelFormat&) const = default;
};

class Drawable {
public:
    // Throws std::bad_alloc if device memory is full.
    Drawable(Device& device,
             MemoryAllocator& memory,
             PixelFormat format,
             unsigned width,
             unsigned height);
    ~Drawable();
    Drawable(const Drawable&) = delete;
    Drawable& operator=(const Drawable&) = delete;

    // New size, at most MaxSurfaceSize; the contents of the common part (from the lower left) stay,
    // the rest is zero.
    void resize(unsigned width, unsigned height);

    const PixelFormat& format() const { return format_; }
    unsigned width() const { return width_; }
    unsigned height() const { return height_; }
    const Surface& front() const { return front_; }
    const Surface& back() const { return format_.double_buffer ? back_ : front_; }
    const Surface& depth() const { return depth_; }
    std::vector<std::int16_t>& accumulation() {
        return accumulation_;
    } // r g b a a pixel, made at first use

    // The back buffer becomes the front buffer; the back buffer's content is then undefined (it is
    // the picture before the last).
    void swap();

private:
    Device& device_;
    MemoryAllocator& memory_;
    PixelFormat format_;
    unsigned width_ = 0, height_ = 0;
    Surface front_, back_, depth_;
    std::vector<std::int16_t> accumulation_;
};

} // namespace ffgpu::gl
