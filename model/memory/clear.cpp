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

// One mask bit a channel to one mask byte a channel.
std::uint32_t byte_mask(unsigned channels) {
    std::uint32_t mask = 0;
    for (unsigned i = 0; i < 4; ++i)
        if ((channels >> i & 1) != 0) mask |= 0xffu << 8 * i;
    return mask;
}

std::uint16_t rgb565_mask(unsigned channels) {
    return static_cast<std::uint16_t>(((channels & 1) != 0 ? 0xf800 : 0) |
                                      ((channels & 2) != 0 ? 0x07e0 : 0) |
                                      ((channels & 4) != 0 ? 0x001f : 0));
}

void clear_rgb565(const Surface& surface,
                  std::uint32_t color,
                  const Registers& registers,
                  Rectangle cut,
                  std::span<std::byte> memory) {
    const std::uint16_t mask = rgb565_mask(registers.blend.write_mask);
    for_rows(surface, cut, memory, [&](int y, std::byte* at) {
        for (int x = cut.x0; x < cut.x1; ++x, at += 2) {
            const std::uint16_t pixel = registers.fragment.dither
                                            ? dither_rgb565(color,
                                                            static_cast<std::uint32_t>(x),
                                                            static_cast<std::uint32_t>(y))
                                            : rgb565_from_rgba8(color);
            MaskedFill<std::uint16_t>{pixel, mask}.row(at, 1);
        }
    });
}

void clear_color(const Surface& surface,
                 std::uint32_t color,
                 const Registers& registers,
                 Rectangle rectangle,
                 std::span<std::byte> memory) {
    const Rectangle cut = cut_to(surface, rectangle);
    if (cut.empty()) return;
    MaskedFill<std::uint32_t> fill{color, byte_mask(registers.blend.write_mask)};
    switch (surface.format) {
    case Format::Rgb565:
        return clear_rgb565(surface, color, registers, cut, memory);
    case Format::Rgbx8:
        fill = {color | 0xff000000u, fill.mask | 0xff000000u};
        [[fallthrough]];
    case Format::Rgba8:
        return for_rows(
            surface, cut, memory, [&](int, std::byte* at) { fill.row(at, cut.width()); });
    default:
        return;
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
    if (clear.color)
        for (const Surface& target : registers.targets.color)
            for_planes(target, memory, [&](const Surface& plane) {
                clear_color(plane, clear.color_value, registers, rectangle, memory);
            });
    if (clear.depth || clear.stencil)
        for_planes(registers.targets.depth, memory, [&](const Surface& plane) {
            clear_depth_stencil(plane, clear, registers, rectangle, memory);
        });
}

} // namespace ffgpu
