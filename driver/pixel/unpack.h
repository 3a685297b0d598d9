// Reads the application's pixels: rows of any format and type as colours, depths or indices.

#pragma once

#include "driver/pixel/pixel_layout.h"
#include "driver/pixel/pixel_transfer.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ffgpu::gl {

struct PixelSource {
    const std::byte* memory = nullptr;
    PixelLayout layout;
    ImageSize size;
    GLenum format = GL_RGBA;
    GLenum type = GL_UNSIGNED_BYTE;
    bool swap_bytes = false;
    bool lsb_first = false;

    PixelSource() = default;
    PixelSource(const void* pixels,
                const PixelStore& store,
                ImageSize image_size,
                GLenum pixel_format,
                GLenum pixel_type,
                bool three_d = false);

    const std::byte* row(GLsizei y, GLsizei z = 0) const {
        return memory + layout.row(static_cast<std::uint64_t>(y), static_cast<std::uint64_t>(z));
    }
    std::size_t width() const { return static_cast<std::size_t>(size.width); }
};

// One row, size.width pixels. Colour formats only.
void unpack_colors(const PixelSource& source, const std::byte* row, PixelColor* colors);

// GL_DEPTH_COMPONENT, and the depth of GL_DEPTH_STENCIL.
void unpack_depths(const PixelSource& source, const std::byte* row, double* depths);

// GL_COLOR_INDEX, GL_STENCIL_INDEX, and the stencil of GL_DEPTH_STENCIL.
void unpack_indices(const PixelSource& source, const std::byte* row, std::int32_t* indices);

// A row of colours or colour indices after pixel transfer.
void unpack_transferred(const PixelSource& source,
                        const PixelState& transfer,
                        const std::byte* row,
                        std::vector<PixelColor>& colors);

// Whether a GL_BITMAP's pixel is set.
inline bool bitmap_pixel(const PixelSource& source, const std::byte* row, std::size_t x) {
    const std::size_t bit = x + source.layout.first_bit;
    const unsigned byte = std::to_integer<unsigned>(row[bit / 8]);
    return (byte >> (source.lsb_first ? bit % 8 : 7 - bit % 8) & 1) != 0;
}

} // namespace ffgpu::gl
