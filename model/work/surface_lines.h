// Which bytes of which lines of a surface an operation writes: a quad's, or a rectangle's that is
// cleared or copied. Computed from coordinates and the surface's layout alone.

#pragma once

#include "model/device/commands.h"
#include "model/packets/rectangle.h"
#include "model/work/address_map.h"
#include "model/work/line_mask.h"
#include "model/work/prepared_work.h"

#include <array>
#include <cstdint>
#include <vector>

namespace ffgpu::work {

struct WrittenLine {
    std::uint64_t number = 0; // address / line bytes
    WrittenBytes bytes;
};

// Of a pixel's bytes, bit i for byte i: those that are written at all, and those wholly.
struct PixelBytes {
    std::uint32_t touched = 0;
    std::uint32_t covered = 0;
};

// What is written of a pixel under the write masks: by a draw or a clear; by a clear.
PixelBytes written_color_bytes(Format format, unsigned write_mask);
PixelBytes cleared_depth_bytes(Format format, const ClearCommand& clear, unsigned stencil_mask);
PixelBytes whole_pixel(Format format);

// The pixels of a quad in a surface, and which of them are written; of several samples a pixel, of
// which samples.
struct WrittenQuad {
    std::array<std::uint64_t, 4> addresses{};
    std::uint8_t lanes = 0;
    std::uint16_t samples = 0; // as WorkQuad has them
};

// What it writes of line `number`: `bytes` of each sample.
WrittenBytes quad_bytes(const PlacedLevel& place,
                        const LineGrain& grain,
                        const WrittenQuad& quad,
                        std::uint64_t number,
                        PixelBytes bytes);

// The lines of which the rectangle's pixels write something, in ascending order. The rectangle is
// cut to the surface.
std::vector<WrittenLine> rectangle_lines(const PlacedLevel& place,
                                         const LineGrain& grain,
                                         Rectangle rectangle,
                                         PixelBytes pixel);

} // namespace ffgpu::work
