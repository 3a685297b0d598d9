#include "driver/pixel/pack.h"

#include "driver/pixel/elements.h"
#include "driver/pixel/pixel_format.h"

#include <array>

namespace ffgpu::gl {

namespace {

std::array<float, 4>
components_of(const ComponentOrder& order, const PixelColor& color, bool sums_luminance) {
    std::array<float, 4> components{};
    for (std::size_t i = 0; i < order.count; ++i)
        components[i] = clamp_unit(color[order.channel[i]]);
    if (order.luminance && sums_luminance) {
        components[0] = clamp_unit(color[0]) + clamp_unit(color[1]) + clamp_unit(color[2]);
    }
    return components;
}

void pack_packed_colors(const PixelDestination& destination,
                        std::byte* row,
                        const PixelColor* colors) {
    const PackedType packed = packed_type(destination.type);
    const ComponentOrder order = component_order(destination.format);
    for (std::size_t x = 0; x < destination.width(); ++x) {
        const std::array<float, 4> components =
            components_of(order, colors[x], destination.sums_luminance);
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < packed.count; ++i) {
            const auto [shift, bits] = packed.fields[i];
            word |= unorm(static_cast<double>(components[i]), bits) << shift;
        }
        store_packed(row + x * packed.bytes, packed.bytes, word, destination.swap_bytes);
    }
}

void pack_bitmap(const PixelDestination& destination, std::byte* row, const std::int32_t* indices) {
    for (std::size_t x = 0; x < destination.width(); ++x) {
        const std::size_t bit = x + destination.layout.first_bit;
        const unsigned place = destination.lsb_first ? bit % 8 : 7 - bit % 8;
        const auto mask = static_cast<std::byte>(1u << place);
        std::byte& byte = row[bit / 8];
        byte = (indices[x] & 1) != 0 ? byte | mask : byte & ~mask;
    }
}

} // namespace

PixelDestination::PixelDestination(void* pixels,
                                   const PixelStore& store,
                                   ImageSize image_size,
                                   GLenum pixel_format,
                                   GLenum pixel_type,
                                   bool three_d)
    : memory(static_cast<std::byte*>(pixels))
    , layout(pixel_layout(store, image_size, pixel_format, pixel_type, three_d))
    , size(image_size)
    , format(pixel_format)
    , type(pixel_type)
    , swap_bytes(store.swap_bytes)
    , lsb_first(store.lsb_first) {}

void pack_colors(const PixelDestination& destination, std::byte* row, const PixelColor* colors) {
    if (packed_type(destination.type).count > 0)
        return pack_packed_colors(destination, row, colors);
    const ComponentOrder order = component_order(destination.format);
    with_element_type(destination.type, [&](auto element) {
        using Element = decltype(element);
        for (std::size_t x = 0; x < destination.width(); ++x) {
            const std::array<float, 4> components =
                components_of(order, colors[x], destination.sums_luminance);
            for (std::size_t i = 0; i < order.count; ++i) {
                const auto real = static_cast<double>(components[i]);
                store_element(row, element_from_real<Element>(real), destination.swap_bytes);
                row += sizeof(Element);
            }
        }
    });
}

void pack_depths(const PixelDestination& destination, std::byte* row, const double* depths) {
    with_element_type(destination.type, [&](auto element) {
        using Element = decltype(element);
        for (std::size_t x = 0; x < destination.width(); ++x) {
            store_element(row + x * sizeof(Element),
                          element_from_real<Element>(depths[x]),
                          destination.swap_bytes);
        }
    });
}

void pack_indices(const PixelDestination& destination,
                  std::byte* row,
                  const std::int32_t* indices) {
    if (destination.type == GL_BITMAP) return pack_bitmap(destination, row, indices);
    with_element_type(destination.type, [&](auto element) {
        using Element = decltype(element);
        for (std::size_t x = 0; x < destination.width(); ++x) {
            store_element(row + x * sizeof(Element),
                          element_from_index<Element>(indices[x]),
                          destination.swap_bytes);
        }
    });
}

void pack_depth_stencil(const PixelDestination& destination,
                        std::byte* row,
                        const std::uint32_t* words) {
    for (std::size_t x = 0; x < destination.width(); ++x)
        store_element(row + 4 * x, words[x], destination.swap_bytes);
}

} // namespace ffgpu::gl
