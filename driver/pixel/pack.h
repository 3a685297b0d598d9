// Writes pixels to the application's memory: rows of colours, depths or indices in any format and
// type.

#pragma once

#include "driver/pixel/pixel_layout.h"
#include "driver/pixel/pixel_transfer.h"

#include <cstddef>
#include <cstdint>

namespace ffgpu::gl {

struct PixelDestination {
    std::byte* memory = nullptr;
    PixelLayout layout;
    ImageSize size;
    GLenum format = GL_RGBA;
    GLenum type = GL_UNSIGNED_BYTE;
    bool swap_bytes = false;
    bool lsb_first = false;
    bool sums_luminance = true; // of red, green and blue (GL 1.5, 4.3.2); false: it is red (6.1.4)

    PixelDestination(void* pixels,
                     const PixelStore& store,
                     ImageSize image_size,
                     GLenum pixel_format,
                     GLenum pixel_type,
                     bool three_d = false);

    std::byte* row(GLsizei y, GLsizei z = 0) const {
        return memory + layout.row(static_cast<std::uint64_t>(y), static_cast<std::uint64_t>(z));
    }
    std::size_t width() const { return static_cast<std::size_t>(size.width); }
};

// One row, size.width pixels.
void pack_colors(const PixelDestination& destination, std::byte* row, const PixelColor* colors);
void pack_depths(const PixelDestination& destination, std::byte* row, const double* depths);
void pack_indices(const PixelDestination& destination, std::byte* row, const std::int32_t* indices);

// GL_DEPTH_STENCIL: depth in the upper 24 bits, stencil in the lower 8.
void pack_depth_stencil(const PixelDestination& destination,
                        std::byte* row,
                        const std::uint32_t* words);

} // namespace ffgpu::gl
