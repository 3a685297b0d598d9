#include "driver/pixel/pixel_layout.h"

#include "driver/pixel/pixel_format.h"

namespace ffgpu::gl {

namespace {

constexpr std::uint64_t unsigned_of(GLint value) {
    return static_cast<std::uint64_t>(value); // Pixel store parameters are not negative.
}

constexpr std::uint64_t round_up(std::uint64_t value, std::uint64_t multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

// Beyond any memory: skips and strides that an application may set, but nothing can hold.
bool is_huge(const PixelStore& store, ImageSize size, const PixelLayout& layout, bool three_d) {
    const double rows = static_cast<double>(size.height) + static_cast<double>(store.skip_rows);
    const double images = static_cast<double>(size.depth) + static_cast<double>(store.skip_images);
    const double image_rows =
        static_cast<double>(three_d && store.image_height > 0 ? store.image_height : size.height);
    const double stride = static_cast<double>(layout.row_stride);
    return stride * (rows + (three_d ? images * image_rows : 0.0)) > 1e18;
}

} // namespace

PixelLayout
pixel_layout(const PixelStore& store, ImageSize size, GLenum format, GLenum type, bool three_d) {
    const std::uint64_t row_pixels =
        unsigned_of(store.row_length > 0 ? store.row_length : size.width);
    const std::uint64_t alignment = unsigned_of(store.alignment);
    const std::uint64_t skipped = unsigned_of(store.skip_pixels);
    const std::uint64_t width = unsigned_of(size.width);

    PixelLayout layout;
    std::uint64_t used; // bytes of a row from its first pixel on
    if (type == GL_BITMAP) {
        layout.row_stride = round_up((row_pixels + 7) / 8, alignment);
        layout.first = skipped / 8;
        layout.first_bit = static_cast<unsigned>(skipped % 8);
        used = (layout.first_bit + width + 7) / 8;
    } else {
        const std::uint64_t pixel = pixel_bytes(format, type);
        const std::uint64_t element = type_bytes(type);
        layout.row_stride = pixel * row_pixels;
        if (element < alignment) layout.row_stride = round_up(layout.row_stride, alignment);
        layout.first = skipped * pixel;
        used = width * pixel;
    }
    layout.first += unsigned_of(store.skip_rows) * layout.row_stride;
    const std::uint64_t rows =
        unsigned_of(three_d && store.image_height > 0 ? store.image_height : size.height);
    layout.image_stride = rows * layout.row_stride;
    if (three_d) layout.first += unsigned_of(store.skip_images) * layout.image_stride;
    if (!size.empty() && is_huge(store, size, layout, three_d)) {
        layout.end = ~std::uint64_t{0}; // The sums above may have wrapped around.
    } else if (!size.empty()) {
        layout.end = layout.row(unsigned_of(size.height) - 1, unsigned_of(size.depth) - 1) + used;
        if (store.invert) {
            layout.first = layout.row(unsigned_of(size.height) - 1);
            layout.row_stride = 0 - layout.row_stride;
        }
    }
    return layout;
}

} // namespace ffgpu::gl
