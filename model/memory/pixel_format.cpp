#include "model/memory/pixel_format.h"

#include "model/base/check.h"

#include <algorithm>
#include <type_traits>

namespace ffgpu {
namespace {

// Reads or writes one pixel after the other: `each(index, address)`.
template <unsigned Bytes, class Count, class Address, class Each>
void for_pixels(Count count, Address* at, Each&& each) {
    for (std::size_t i = 0; i < count; ++i, at += Bytes)
        each(i, at);
}

// The word of memory that holds a pixel.
template <Format Known>
using PixelWord = std::conditional_t<
    format_info(Known).block_bytes == 1,
    std::uint8_t,
    std::conditional_t<format_info(Known).block_bytes == 2, std::uint16_t, std::uint32_t>>;

} // namespace

void load_rgba8(Format format, const std::byte* from, std::span<std::uint32_t> colors) {
    const bool known = visit_plain_color(format, [&](auto tag) {
        using Word = PixelWord<tag.value>;
        for_pixels<sizeof(Word)>(colors.size(), from, [&](std::size_t i, const std::byte* at) {
            colors[i] = unpack_pixel(tag.value, load_word<Word>(at));
        });
    });
    check(known, "load_rgba8: not a plain colour format");
}

void store_rgba8(Format format, std::span<const std::uint32_t> colors, std::byte* to) {
    const bool known = visit_plain_color(format, [&](auto tag) {
        using Word = PixelWord<tag.value>;
        for_pixels<sizeof(Word)>(colors.size(), to, [&](std::size_t i, std::byte* at) {
            store_word(at, static_cast<Word>(pack_pixel(tag.value, colors[i])));
        });
    });
    check(known, "store_rgba8: not a plain colour format");
}

std::uint32_t depth_units(Format format, float depth) {
    const std::uint32_t maximum = format == Format::Depth16 ? 0xffff : Depth24Maximum;
    if (!(depth > 0.0f)) return 0;
    if (depth >= 1.0f) return maximum;
    return static_cast<std::uint32_t>(static_cast<double>(depth) * maximum + 0.5);
}

void load_depth24(Format format, const std::byte* from, std::span<std::uint32_t> depths) {
    if (format == Format::Depth16) {
        for_pixels<2>(depths.size(), from, [&](std::size_t i, const std::byte* at) {
            depths[i] = depth24_from_depth16(load_word<std::uint16_t>(at));
        });
        return;
    }
    check(format == Format::Depth24Stencil8, "load_depth24: not a depth format");
    for_pixels<4>(depths.size(), from, [&](std::size_t i, const std::byte* at) {
        depths[i] = load_word<std::uint32_t>(at) >> 8;
    });
}

void store_depth24(Format format, std::span<const std::uint32_t> depths, std::byte* to) {
    if (format == Format::Depth16) {
        for_pixels<2>(depths.size(), to, [&](std::size_t i, std::byte* at) {
            store_word(at, static_cast<std::uint16_t>(depth16_from_depth24(depths[i])));
        });
        return;
    }
    check(format == Format::Depth24Stencil8, "store_depth24: not a depth format");
    for_pixels<4>(depths.size(), to, [&](std::size_t i, std::byte* at) {
        store_word(at, depths[i] << 8 | (load_word<std::uint32_t>(at) & 255));
    });
}

} // namespace ffgpu
