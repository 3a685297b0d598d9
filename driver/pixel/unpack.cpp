#include "driver/pixel/unpack.h"

#include "driver/pixel/elements.h"
#include "driver/pixel/pixel_format.h"

#include <algorithm>
#include <array>

namespace ffgpu::gl {

namespace {

// `count` elements from `at` on, as reals.
template <class Real>
void read_reals(const PixelSource& source, const std::byte* at, std::size_t count, Real* reals) {
    with_element_type(source.type, [&](auto element) {
        using Element = decltype(element);
        for (std::size_t i = 0; i < count; ++i) {
            const auto value = load_element<Element>(at + i * sizeof(Element), source.swap_bytes);
            reals[i] = static_cast<Real>(real_from_element(value));
        }
    });
}

PixelColor color_of(const ComponentOrder& order, const float* components) {
    PixelColor color{0, 0, 0, 1};
    for (std::size_t i = 0; i < order.count; ++i)
        color[order.channel[i]] = components[i];
    if (order.luminance) color[1] = color[2] = color[0];
    return color;
}

void unpack_packed_colors(const PixelSource& source, const std::byte* row, PixelColor* colors) {
    const PackedType packed = packed_type(source.type);
    const ComponentOrder order = component_order(source.format);
    for (std::size_t x = 0; x < source.width(); ++x) {
        const std::uint32_t word =
            load_packed(row + x * packed.bytes, packed.bytes, source.swap_bytes);
        std::array<float, 4> components{};
        for (std::size_t i = 0; i < packed.count; ++i) {
            const auto [shift, bits] = packed.fields[i];
            const std::uint32_t max = (1u << bits) - 1;
            components[i] = static_cast<float>(word >> shift & max) / static_cast<float>(max);
        }
        colors[x] = color_of(order, components.data());
    }
}

} // namespace

PixelSource::PixelSource(const void* pixels,
                         const PixelStore& store,
                         ImageSize image_size,
                         GLenum pixel_format,
                         GLenum pixel_type,
                         bool three_d)
    : memory(static_cast<const std::byte*>(pixels))
    , layout(pixel_layout(store, image_size, pixel_format, pixel_type, three_d))
    , size(image_size)
    , format(pixel_format)
    , type(pixel_type)
    , swap_bytes(store.swap_bytes)
    , lsb_first(store.lsb_first) {}

void unpack_colors(const PixelSource& source, const std::byte* row, PixelColor* colors) {
    if (packed_type(source.type).count > 0) return unpack_packed_colors(source, row, colors);
    const ComponentOrder order = component_order(source.format);
    constexpr std::size_t Chunk = 64; // pixels
    std::array<float, 4 * Chunk> components;
    const std::size_t pixel = order.count * type_bytes(source.type);
    for (std::size_t x = 0; x < source.width(); x += Chunk) {
        const std::size_t count = std::min(Chunk, source.width() - x);
        read_reals(source, row + x * pixel, count * order.count, components.data());
        for (std::size_t i = 0; i < count; ++i)
            colors[x + i] = color_of(order, components.data() + i * order.count);
    }
}

void unpack_depths(const PixelSource& source, const std::byte* row, double* depths) {
    if (source.type != GL_UNSIGNED_INT_24_8) return read_reals(source, row, source.width(), depths);
    for (std::size_t x = 0; x < source.width(); ++x) {
        const auto word = load_element<std::uint32_t>(row + 4 * x, source.swap_bytes);
        depths[x] = (word >> 8) / 16777215.0;
    }
}

void unpack_indices(const PixelSource& source, const std::byte* row, std::int32_t* indices) {
    if (source.type == GL_BITMAP) {
        for (std::size_t x = 0; x < source.width(); ++x)
            indices[x] = bitmap_pixel(source, row, x);
        return;
    }
    if (source.type == GL_UNSIGNED_INT_24_8) {
        for (std::size_t x = 0; x < source.width(); ++x) {
            const auto word = load_element<std::uint32_t>(row + 4 * x, source.swap_bytes);
            indices[x] = static_cast<std::int32_t>(word & 0xff);
        }
        return;
    }
    with_element_type(source.type, [&](auto element) {
        using Element = decltype(element);
        for (std::size_t x = 0; x < source.width(); ++x) {
            indices[x] = index_from_element(
                load_element<Element>(row + x * sizeof(Element), source.swap_bytes));
        }
    });
}

void unpack_transferred(const PixelSource& source,
                        const PixelState& transfer,
                        const std::byte* row,
                        std::vector<PixelColor>& colors) {
    colors.resize(source.width());
    if (source.format == GL_COLOR_INDEX) {
        std::vector<std::int32_t> indices(source.width());
        unpack_indices(source, row, indices.data());
        transfer_indices(transfer, indices, colors.data());
        return;
    }
    unpack_colors(source, row, colors.data());
    transfer_colors(transfer, colors);
}

} // namespace ffgpu::gl
