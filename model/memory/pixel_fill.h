// PixelFill: what a clear does to each pixel of a target.

#pragma once

#include "model/device/commands.h"
#include "model/device/registers.h"
#include "model/memory/color_pixel.h"

#include <cstdint>

namespace ffgpu {

struct PixelFill {
    std::uint32_t value = 0; // of a pixel's word
    std::uint32_t mask = 0;  // the bits that are written
    std::uint32_t color = 0; // of a dithered fill: rgba8
    Format dithered = Format::None;

    std::uint32_t value_at(std::uint32_t x, std::uint32_t y) const {
        if (dithered == Format::None) return value;
        return pack_pixel(dithered, color, Dithered{bayer_threshold(x, y)});
    }
};

// `color`: rgba8, as cleared_color() has it for the target.
inline PixelFill color_fill(const Registers& registers, Format format, std::uint32_t color) {
    PixelFill fill{.value = pack_pixel(format, color),
                   .mask = pixel_bits(format, registers.blend.write_mask),
                   .color = color};
    if (is_narrow(format) && registers.fragment.dither) fill.dithered = format;
    return fill;
}

// Format: Depth16 or Depth24Stencil8.
inline PixelFill depth_fill(const Registers& registers, Format format, const ClearCommand& clear) {
    if (format == Format::Depth16)
        return {.value = clear.depth_value & 0xffff, .mask = clear.depth ? 0xffffu : 0u};
    return {.value = clear.depth_value << 8 | clear.stencil_value,
            .mask = (clear.depth ? 0xffffff00u : 0u) |
                    (clear.stencil ? registers.stencil.front.write_mask : 0u)};
}

} // namespace ffgpu
