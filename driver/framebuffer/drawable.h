// Drawable: the surfaces of a window, pixmap or off-screen buffer: front and back colour, depth and
// stencil, accumulation. They live in device memory; row 0 is the lowest.
//
// Those of a multisampled drawable hold several samples of each pixel, those of a supersampled one
// are several, one behind the other (Surface::plane()). Whoever reads pixels gets them resolved,
// from a surface beside the colour buffers that follows what is drawn.

#pragma once

#include "driver/memory_allocator.h"
#include "model/device/device.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ffgpu::gl {

// What a GLX visual, an EGL config or a test asks for.
struct PixelFormat {
    bool double_buffer = true;
    bool alpha = true;
    std::uint8_t depth_bits = 24;  // 0, 16 or 24
    std::uint8_t stencil_bits = 8; // 0 or 8; 8 goes with 24 depth bits
    bool accumulation = true;      // 16 bits signed a channel
    std::uint8_t samples = 1;      // of a pixel: 1 or MaxSamples
    // Pictures that lie one behind the other, each drawn for itself, and are one for who looks: up
    // to MaxSupersampling. 1 where there are samples.
    std::uint8_t supersampling = 1;

    bool operator==(const PixelFormat&) const = default;
};

// What a swap leaves in the back buffer.
enum class SwapMode : std::uint8_t {
    Copy,     // what it had: the front buffer gets a copy
    Exchange, // what the front buffer had: the picture before the last
};

class Drawable {
public:
    // Sizes beyond MaxSurfaceSize are cut to it. Throws std::bad_alloc if device memory is full.
    Drawable(Device& device,
             MemoryAllocator& memory,
             PixelFormat format,
             unsigned width,
             unsigned height);
    ~Drawable();
    Drawable(const Drawable&) = delete;
    Drawable& operator=(const Drawable&) = delete;

    // The contents of the common part (from the lower left) stay, the rest is zero; so is all of
    // the accumulation buffer. Throws as the constructor, and then nothing has changed.
    void resize(unsigned width, unsigned height);

    // Counts the changes of the surfaces below (resize, swap), so that contexts notice them.
    unsigned generation() const { return generation_; }

    const PixelFormat& format() const { return format_; }
    unsigned width() const { return width_; }
    unsigned height() const { return height_; }

    // What is drawn to, of format().samples samples a pixel. Supersampled: the first picture.
    const Surface& front() const { return surfaces_.front; }
    const Surface& back() const { return format_.double_buffer ? surfaces_.back : surfaces_.front; }
    const Surface& depth() const { return surfaces_.depth; }
    // Who reads pixels reads a resolved copy.
    bool is_resolved() const { return format_.samples > 1 || format_.supersampling > 1; }
    // Commands follow that draw to any of them.
    void note_drawing() { resolved_from_.reset(); }

    // To be called before colours are drawn or read: see swap().
    void settle() {
        if (copy_is_due_) [[unlikely]]
            copy_to_back();
    }
    // All of the back buffer's colours will be overwritten by the next command.
    void note_back_overwritten() { copy_is_due_ = false; }

    // The same with one sample a pixel, as it is now: colours are the average of the samples or
    // pictures, depth and stencil those of the first. One colour buffer at a time: the next call
    // may replace it.
    Surface readable_front() { return resolve(front()); }
    Surface readable_back() {
        settle();
        return resolve(back());
    }
    Surface readable_depth() const { return depth().plane(0); }

    // r g b a of each pixel, from the lower left; all 0 at first. Empty where the format has none.
    std::vector<std::int16_t>& accumulation();

    // The back buffer's picture becomes the front buffer's. In either mode the buffers change their
    // roles; that the back buffer keeps its picture costs a copy, which is made by settle(), and
    // never for a program that begins its frames with a clear.
    void swap(SwapMode mode);

private:
    struct Surfaces {
        Surface front, back, depth;
        Surface resolved; // of the colour buffer that was read last; none where it needs none
    };
    Surface allocate(const Surface& shape, unsigned pictures);
    Surfaces allocate_all(unsigned width, unsigned height);
    void release(Surfaces& surfaces);
    void clear(const Surface& surface);
    void copy_to_back();
    void copy_pictures(const Surface& from, const Surface& to);
    void copy_common_part(const CopyRectangleCommand& surfaces);
    Surface resolve(const Surface& buffer);

    Device& device_;
    MemoryAllocator& memory_;
    PixelFormat format_;
    unsigned width_ = 0, height_ = 0;
    unsigned generation_ = 0;
    Surfaces surfaces_;
    std::optional<DeviceAddress> resolved_from_; // the buffer that `resolved` shows; or stale
    std::vector<std::int16_t> accumulation_;
    bool copy_is_due_ = false; // The back buffer is to hold what the front buffer holds.
};

} // namespace ffgpu::gl
