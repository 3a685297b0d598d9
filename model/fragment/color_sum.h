// Two short stages on either side of fog: the colour sum (GL 1.5, 3.9) adds the secondary colour,
// clamped, and leaves alpha; coverage (3.3, 3.4, 3.5) multiplies alpha for smooth primitives.

#pragma once

#include "model/fragment/unorm8.h"
#include "model/memory/pixel_format.h"
#include "model/packets/fragment_batch.h"

#include <algorithm>

namespace ffgpu {

constexpr PixelColor add_secondary(PixelColor color, const PixelColor& secondary) {
    for (unsigned channel = 0; channel < 3; ++channel)
        color[channel] =
            static_cast<std::uint8_t>(std::min(255, color[channel] + secondary[channel]));
    return color;
}

// coverage: 0 .. 255; rounded to nearest.
constexpr PixelColor apply_coverage(PixelColor color, std::uint32_t coverage) {
    color[3] = multiply_unorm8(color[3], coverage);
    return color;
}

// --- On batches: every lane of batch.color ------------------------------------------------------

void add_secondary(FragmentBatch& batch);
void add_secondary_scalar(FragmentBatch& batch);
void apply_coverage(FragmentBatch& batch);
void apply_coverage_scalar(FragmentBatch& batch);

} // namespace ffgpu
