// Depth textures: a texel's 24-bit depth becomes a colour, either its own value or the outcome of a
// comparison with the fragment's r coordinate. Filters then work on these colours, which for a
// comparison is percentage-closer filtering.

#pragma once

#include "model/device/compare.h"
#include "model/device/registers/texture.h"
#include "model/texture/filter.h"
#include "model/texture/wrap.h"

#include <cstdint>

namespace ffgpu {

// r clamped to [0, 1], as 24-bit unsigned normalised; one binary32 product, rounded to nearest.
constexpr std::uint32_t reference_depth(float r) {
    const float at_least = r < 0 ? 0.0f : r;
    const float clamped = at_least > 1 ? 1.0f : at_least;
    return static_cast<std::uint32_t>(round_to_int(clamped * 16777215.0f));
}

constexpr Rgba expand_depth(DepthMode mode, std::uint8_t d) {
    switch (mode) {
    case DepthMode::Intensity:
        return {d, d, d, d};
    case DepthMode::Alpha:
        return {0, 0, 0, d};
    default:
        return {d, d, d, 255};
    }
}

// An uncompared depth shows its leading 8 bits.
constexpr Rgba depth_color(const Sampler& sampler, std::uint32_t reference, std::uint32_t depth) {
    const bool passes = compare(sampler.compare, reference, depth);
    const std::uint32_t value = sampler.compare_enable ? (passes ? 255u : 0u) : depth >> 16;
    return expand_depth(sampler.depth_mode, static_cast<std::uint8_t>(value));
}

} // namespace ffgpu
