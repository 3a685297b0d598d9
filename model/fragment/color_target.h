// The last stage: blends or combines the colours of a batch with a colour target, in the
// precision of its format, under its write mask.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/fragment/blend.h"
#include "model/packets/fragment_batch.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

struct ColorTarget {
    Surface surface;             // Format::None: nothing is written
    std::uint8_t write_mask = 0; // one bit a channel, of those that the format has
    bool srgb = false;           // It holds sRGB codes.
};

// Formats of less than 8 bits a channel are dithered where the draw dithers; with a logic operation
// the source is brought to the format's precision and channels first. On a target of sRGB codes it
// is written as it is (EXT_framebuffer_sRGB).
struct ColorStage {
    Blend state;
    ColorOperation operation = ColorOperation::Replace;
    BlendKernel kernel = nullptr; // for ColorOperation::Blend
    bool dither = false;
};

ColorStage compile_color_stage(const Blend& blend, bool dither);

struct ColoredFragment {
    std::uint32_t x, y; // pixel of the window
    PixelColor color;
};

// As the target will hold it, before its precision: blended, or the source; encoded where the
// target holds codes.
PixelColor
blended_color(const ColorStage& stage, bool srgb, PixelColor source, const PixelColor& stored);

// The specification: how the pixel reads afterwards that reads `stored` now.
PixelColor written_color(const ColorStage& stage,
                         const ColorTarget& target,
                         ColoredFragment fragment,
                         const PixelColor& stored);

// --- On batches: writes the fragments in batch.live
// -----------------------------------------------

void write_color_scalar(const ColorStage& stage,
                        const ColorTarget& target,
                        const FragmentBatch& batch,
                        std::span<std::byte> memory);
void write_color(const ColorStage& stage,
                 const ColorTarget& target,
                 const FragmentBatch& batch,
                 std::span<std::byte> memory);

} // namespace ffgpu
