#include "model/memory/clear.h"

#include "model/memory/pixel_format.h"

#include <cstddef>
#include <cstdint>

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

// A tile's rows lie in pages of their own: a host that foresees loads and stores foresees none of
// the next row. That one's bytes may lie outside of the memory; nothing is done with them.
void fetch_row_ahead(const std::byte* at, std::size_t stride, std::size_t bytes) {
    constexpr std::size_t Ahead = 6, CacheLine = 64;
    const auto first = reinterpret_cast<std::uintptr_t>(at) + Ahead * stride;
    for (std::size_t i = 0; i < bytes; i += CacheLine)
        __builtin_prefetch(reinterpret_cast<const void*>(first + i), 1);
}

// `rectangle` is a part of the surface.
template <class Word>
void fill_words(const Surface& surface,
                const PixelFill& fill,
                const Rectangle& rectangle,
                std::span<std::byte> memory) {
    const auto filling = [&fill](std::uint32_t value) {
        return MaskedFill<Word>{static_cast<Word>(value), static_cast<Word>(fill.mask)};
    };
    const std::size_t row_bytes = static_cast<std::size_t>(rectangle.width()) * sizeof(Word);
    const auto x0 = static_cast<std::uint32_t>(rectangle.x0);
    for (auto y = static_cast<std::uint32_t>(rectangle.y0); static_cast<int>(y) < rectangle.y1;
         ++y) {
        std::byte* at = pixel_address(surface, memory, x0, y);
        if (fill.dithered == Format::None) {
            fetch_row_ahead(at, surface.stride, row_bytes);
            filling(fill.value).row(at, rectangle.width());
            continue;
        }
        for (auto x = x0; static_cast<int>(x) < rectangle.x1; ++x, at += sizeof(Word))
            filling(fill.value_at(x, y)).row(at, 1);
    }
}

void fill_plane(const Surface& surface,
                const PixelFill& fill,
                const Rectangle& rectangle,
                std::span<std::byte> memory) {
    const Rectangle cut = intersect(rectangle, {0, 0, surface.width, surface.height});
    if (cut.empty()) return;
    switch (format_info(surface.format).block_bytes) {
    case 1:
        return fill_words<std::uint8_t>(surface, fill, cut, memory);
    case 2:
        return fill_words<std::uint16_t>(surface, fill, cut, memory);
    default:
        return fill_words<std::uint32_t>(surface, fill, cut, memory);
    }
}

} // namespace

std::array<PixelFill, ColorTargets + 1> target_fills(const ClearCommand& clear,
                                                     const Registers& registers) {
    std::array<PixelFill, ColorTargets + 1> fills;
    for (unsigned i = 0; clear.color && i < ColorTargets; ++i) {
        const Format format = registers.targets.color[i].format;
        if (is_plain_color(format))
            fills[i] = color_fill(
                registers, format, cleared_color(registers.fragment, i, clear.color_value));
    }
    const Format format = registers.targets.depth.format;
    if (is_depth_target(format)) fills.back() = depth_fill(registers, format, clear);
    return fills;
}

void fill_target(const Surface& target,
                 const PixelFill& fill,
                 const Rectangle& rectangle,
                 std::span<std::byte> memory) {
    if (fill.mask == 0 || !surface_fits(target, memory.size())) return;
    for (unsigned i = 0; i < target.samples; ++i)
        fill_plane(target.plane(i), fill, rectangle, memory);
}

void clear_rectangle(const ClearCommand& clear,
                     const Registers& registers,
                     const Rectangle& rectangle,
                     std::span<std::byte> memory) {
    const auto fills = target_fills(clear, registers);
    std::size_t place = 0;
    Targets::for_each(registers.targets, [&](const Surface& target) {
        fill_target(target, fills[place++], rectangle, memory);
    });
}

} // namespace ffgpu
