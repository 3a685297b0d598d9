// Multisample fragment operations (GL 1.5, 4.1.3): alpha may take samples out of a fragment's
// coverage, and the sample mask does. They stand before the alpha test.

#pragma once

#include "model/device/registers/fragment.h"
#include "model/memory/pixel_format.h"
#include "model/packets/fragment_batch.h"

#include <cstdint>

namespace ffgpu {

// The samples, a bit each, that alpha of 0 .. 255 covers in pixel (x, y) of the window: n of the
// four, n = floor(4 alpha / 255 + t), t being one of 1/32, 3/32 .. 31/32 by the place in a block of
// 4x4 pixels. So their mean over the block is proportional to alpha in 64 steps, 0 covers none and
// 255 all, and a larger alpha covers what a smaller one does. The sample that comes first also goes
// by the place.
constexpr unsigned alpha_coverage(std::uint32_t alpha, std::uint32_t x, std::uint32_t y) {
    const std::uint32_t place = bayer_threshold(x, y);
    const std::uint32_t count = (128 * alpha + 255 * (2 * place + 1)) / (255 * 32);
    const unsigned run = (1u << count) - 1, first = place % MaxSamples;
    return (run << first | run >> (MaxSamples - first)) & ((1u << MaxSamples) - 1);
}

// Narrows batch.samples and batch.live, and sets alpha to 255 where the state says so. Does nothing
// where multisampling is off.
void apply_sample_mask(const Multisample& state, FragmentBatch& batch);

} // namespace ffgpu
