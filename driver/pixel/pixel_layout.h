// Where the pixels of an image lie in the application's memory (GL 1.5, 3.6.1 and 3.6.4).

#pragma once

#include "driver/state/pixel_store_state.h"

#include <cstdint>

namespace ffgpu::gl {

struct ImageSize {
    GLsizei width = 0, height = 1, depth = 1;

    bool empty() const { return width <= 0 || height <= 0 || depth <= 0; }
};

struct PixelLayout {
    std::uint64_t first = 0;        // byte of the first pixel, after what is skipped
    std::uint64_t row_stride = 0;   // bytes; modulo 2^64 less than 0 where rows go down in memory
    std::uint64_t image_stride = 0; // bytes
    std::uint64_t end = 0;          // bytes of memory that the image needs; 0 if it is empty
    unsigned first_bit = 0;         // GL_BITMAP: of the first byte of each row

    std::uint64_t row(std::uint64_t y, std::uint64_t z = 0) const {
        return first + y * row_stride + z * image_stride;
    }
};

// Images are skipped, and have a height of their own, in three dimensions only. The format and the
// type fit together.
PixelLayout
pixel_layout(const PixelStore& store, ImageSize size, GLenum format, GLenum type, bool three_d);

} // namespace ffgpu::gl
