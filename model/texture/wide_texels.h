// Texels at any distance from the image's edge, as the wide filters meet them.

#pragma once

#include "model/texture/filter_witness.h"
#include "model/texture/level_of_detail.h"
#include "model/texture/texel_read.h"
#include "model/texture/wrap.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace ffgpu {

constexpr std::int32_t WidestFilter = 64; // texels of a level, but of a summed-area table's: size

// The texel that stands for texel `index` of an axis: -1 and `size` are the border.
constexpr std::int32_t wrapped_texel(Wrap wrap, std::int32_t index, std::int32_t size) {
    const auto clamp_to = [&](std::int32_t low, std::int32_t high) {
        return index < low ? low : index > high ? high : index;
    };
    const auto remainder = [&](std::int32_t period) {
        const std::int32_t rest = index % period;
        return rest < 0 ? rest + period : rest;
    };
    switch (wrap) {
    case Wrap::Repeat:
        return remainder(size);
    case Wrap::MirroredRepeat:
        index = remainder(2 * size);
        return index < size ? index : 2 * size - 1 - index;
    case Wrap::ClampToEdge:
        return clamp_to(0, size - 1);
    case Wrap::Clamp:
    case Wrap::ClampToBorder:
        return clamp_to(-1, size);
    case Wrap::MirrorClampToEdge:
        if (index < 0) index = -1 - index;
        return clamp_to(0, size - 1);
    case Wrap::MirrorClamp:
    case Wrap::MirrorClampToBorder:
        if (index < 0) index = -1 - index;
        return clamp_to(0, size);
    }
    return clamp_to(0, size - 1);
}

// A coordinate among the `size` texels of a level, with 8 fraction bits: brought near the image,
// but not to its texels, which wrapped_texel() does. Repeat: 0 to size; mirrored: 0 to 2 size;
// clamped: no farther out than where any filter sees the edge alone.
// GL_CLAMP alone says something of the coordinate: it is held in [0, 1] before texels are chosen
// around it (GL 1.5, 3.8.7), so that far outside a filter takes half of its texels from the border.
constexpr std::int32_t texel_position(Wrap wrap, float s, std::int32_t size) {
    const std::int32_t length = 256 * size;
    const auto scale = static_cast<float>(length);
    const auto clamped = [&](std::int32_t low, std::int32_t high) {
        return round_to_int(
            std::clamp(s * scale, static_cast<float>(low), static_cast<float>(high)));
    };
    switch (wrap) {
    case Wrap::Repeat:
        return round_to_int(fraction(s) * scale);
    case Wrap::MirroredRepeat:
        return round_to_int(2 * fraction(s * 0.5f) * scale);
    case Wrap::Clamp:
        return clamped(0, length);
    case Wrap::MirrorClamp:
        return clamped(-length, length);
    default:
        return clamped(-2 * length - 256 * WidestFilter, 2 * length + 256 * WidestFilter);
    }
}

// The coordinates' steps from a pixel to the next, in texels of a level.
struct TexelSteps {
    std::array<float, 2> x{}, y{}; // u and v
};

// A step whose u or v is longer than `longest` is made as much shorter.
TexelSteps
texel_steps(const TextureUnit& unit, const QuadSampling& quad, unsigned level, float longest);

// Two columns and two rows of a level, not yet wrapped. Reads them and tells of it as one access.
class TexelBlock {
public:
    TexelBlock(const TextureUnit& unit, unsigned level, const FilterWitness& witness)
        : unit_(unit)
        , witness_(witness)
        , level_(level) {}

    // Texels (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1). Their weights are told, no more.
    std::array<Rgba, 4>
    read(std::int32_t x, std::int32_t y, const std::array<std::int32_t, 4>& weights) const;

private:
    AxisTexels pair(unsigned axis, std::int32_t index) const {
        const Wrap wrap = unit_.sampler.wrap[axis];
        const std::int32_t size = level_extent(unit_, axis, level_);
        return {wrapped_texel(wrap, index, size), wrapped_texel(wrap, index + 1, size), 0};
    }

    const TextureUnit& unit_;
    const FilterWitness& witness_;
    const unsigned level_;
};

} // namespace ffgpu
