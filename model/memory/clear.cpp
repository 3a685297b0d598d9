#include "model/memory/clear.h"

#include "model/memory/pixel_format.h"

#include <algorithm>
#include <bit>

namespace ffgpu {
namespace {

// Of each pixel the bits of `mask` become those of `value`.
template <class Word>
struct MaskedFill {
    Word value;
    Word mask;

    void row(std::byte* at, int count) const {
        const Word bits = static_cast<Word>(value & mask);
        const Word kept = static_cast<Word>(~mask);
        for (int i = 0; i < count; ++i, at += sizeof(Word))
            store_word(at,
                       kept == 0 ? bits : static_cast<Word>((load_word<Word>(at) & kept) | bits));
    }
};

Rectangle cut_to(const Surface& surface, Rectangle rectangle) {
    return intersect(rectangle, {0, 0, surface.width, surface.height});
}

// Calls row(y, address of the first pixel) for each row of the rectangle within the surface.
template <class Row>
void for_rows(const Surface& surface, Rectangle rectangle, std::span<std::byte> memory, Row&& row) {
    for (int y = rectangle.y0; y < rectangle.y1; ++y)
        row(y,
            pixel_address(surface,
                          memory,
                          static_cast<std::uint32_t>(rectangle.x0),
                          static_cast<std::uint32_t>(y)));
}

template <class Word>
void clear_words(const Surface& surface,
                 std::uint32_t color,
                 const Registers& registers,
                 Rectangle cut,
                 std::span<std::byte> memory) {
    const Format format = surface.format;
    const auto mask = static_cast<Word>(pixel_bits(format, registers.blend.write_mask));
    const MaskedFill<Word> fill{static_cast<Word>(pack_pixel(format, color)), mask};
    const bool dithers = is_narrow(format) && registers.fragment.dither;
    for_rows(surface, cut, memory, [&](int y, std::byte* at) {
        if (!dithers) return fill.row(at, cut.width());
        for (int x = cut.x0; x < cut.x1; ++x, at += sizeof(Word)) {
            const Dithered rounding{
                bayer_threshold(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y))};
            const auto pixel = static_cast<Word>(pack_pixel(format, color, rounding));
            MaskedFill<Word>{pixel, mask}.row(at, 1);
        }
    });
}

void clear_color(const Surface& surface,
                 std::uint32_t color,
                 const Registers& registers,
                 Rectangle rectangle,
                 std::span<std::byte> memory) {
    const Rectangle cut = cut_to(surface, rectangle);
    if (cut.empty() || !is_plain_color(surface.format)) return;
    switch (format_info(surface.format).block_bytes) {
    case 1:
        return clear_words<std::uint8_t>(surface, color, registers, cut, memory);
    case 2:
        return clear_words<std::uint16_t>(surface, color, registers, cut, memory);
    default:
        return clear_words<std::uint32_t>(surface, color, registers, cut, memory);
    }
}

void clear_depth_stencil(const Surface& surface,
                         const ClearCommand& clear,
                         const Registers& registers,
                         Rectangle rectangle,
                         std::span<std::byte> memory) {
    const Rectangle cut = cut_to(surface, rectangle);
    if (cut.empty()) return;
    if (surface.format == Format::Depth16) {
        const MaskedFill<std::uint16_t> fill{static_cast<std::uint16_t>(clear.depth_value),
                                             std::uint16_t{0xffff}};
        if (!clear.depth) return;
        for_rows(surface, cut, memory, [&](int, std::byte* at) { fill.row(at, cut.width()); });
    } else if (surface.format == Format::Depth24Stencil8) {
        const std::uint32_t mask = (clear.depth ? 0xffffff00u : 0u) |
                                   (clear.stencil ? registers.stencil.front.write_mask : 0u);
        const MaskedFill<std::uint32_t> fill{clear.depth_value << 8 | clear.stencil_value, mask};
        if (mask == 0) return;
        for_rows(surface, cut, memory, [&](int, std::byte* at) { fill.row(at, cut.width()); });
    }
}

// Calls clear(plane) for each sample's plane of a target that is in memory.
template <class Clear>
void for_planes(const Surface& target, std::span<const std::byte> memory, Clear&& clear) {
    if (!surface_fits(target, memory.size())) return;
    for (unsigned i = 0; i < target.samples; ++i)
        clear(target.plane(i));
}

} // namespace

void clear_rectangle(const ClearCommand& clear,
                     const Registers& registers,
                     Rectangle rectangle,
                     std::span<std::byte> memory) {
    for (unsigned i = 0; clear.color && i < ColorTargets; ++i)
        for_planes(registers.targets.color[i], memory, [&](const Surface& plane) {
            const std::uint32_t color = cleared_color(registers.fragment, i, clear.color_value);
            clear_color(plane, color, registers, rectangle, memory);
        });
    if (clear.depth || clear.stencil)
        for_planes(registers.targets.depth, memory, [&](const Surface& plane) {
            clear_depth_stencil(plane, clear, registers, rectangle, memory);
        });
}

} // namespace ffgpu
