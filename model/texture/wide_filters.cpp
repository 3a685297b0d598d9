#include "model/texture/wide_filters.h"

#include "model/texture/wide_texels.h"

#include <algorithm>
#include <cmath>

namespace ffgpu {

TexelSteps
texel_steps(const TextureUnit& unit, const QuadSampling& quad, unsigned level, float longest) {
    TexelSteps steps;
    const auto shorten = [longest](std::array<float, 2>& step) {
        const float longer = std::max(std::fabs(step[0]), std::fabs(step[1]));
        if (!(longer > longest)) return;
        const float scale = longest / std::min(longer, LargestStep);
        for (float& part : step)
            part = std::clamp(part * scale, -longest, longest);
    };
    for (unsigned axis = 0; axis < 2; ++axis) {
        const auto size = static_cast<float>(level_extent(unit, axis, level));
        steps.x[axis] = quad.steps.x[axis] * size;
        steps.y[axis] = quad.steps.y[axis] * size;
    }
    shorten(steps.x);
    shorten(steps.y);
    return steps;
}

std::array<Rgba, 4>
TexelBlock::read(std::int32_t x, std::int32_t y, const std::array<std::int32_t, 4>& weights) const {
    const std::array<AxisTexels, 3> axes{pair(0, x), pair(1, y), AxisTexels{}};
    const auto stored = [&](unsigned axis, std::int32_t index) {
        return stored_coordinate(unit_, index, level_extent(unit_, axis, level_));
    };
    const AxisTexels &columns = axes[0], &rows = axes[1];
    witness_.tell({.lane = static_cast<std::uint16_t>(witness_.lane),
                   .level = static_cast<std::uint8_t>(level_),
                   .linear = 3,
                   .x0 = stored(0, columns.first),
                   .x1 = stored(0, columns.second),
                   .y0 = stored(1, rows.first),
                   .y1 = stored(1, rows.second),
                   .layer0 = 0,
                   .layer1 = 0},
                  axes);
    std::array<Rgba, 4> texels;
    for (unsigned i = 0; i < 4; ++i)
        texels[i] = read_texel(unit_,
                               {.level = level_,
                                .x = i % 2 ? columns.second : columns.first,
                                .y = i / 2 ? rows.second : rows.first},
                               0,
                               witness_.observer);
    if (witness_.observer) witness_.observer->texel_weights(weights);
    return texels;
}

bool is_wide(const TextureUnit& unit, const QuadSampling& quad) {
    const bool magnified = quad.lambda <= unit.magnify_limit && quad.probes == 1;
    switch (unit.filter) {
    case TextureFilter::Standard:
        return false;
    case TextureFilter::Bicubic:
        return magnified && quad.linear;
    case TextureFilter::Elliptic:
    case TextureFilter::Feline:
        return !magnified;
    case TextureFilter::RipMap:
    case TextureFilter::SummedArea:
        return true;
    }
    return false;
}

Rgba filter_wide(const TextureUnit& unit,
                 const SampledFragment& fragment,
                 const QuadSampling& quad,
                 const FilterWitness& witness) {
    // These two are several probes.
    if (unit.filter == TextureFilter::Feline) return filter_feline(unit, fragment, quad, witness);
    if (unit.filter == TextureFilter::RipMap) return filter_rip_map(unit, fragment, quad, witness);
    witness.begin_probe(fragment);
    switch (unit.filter) {
    case TextureFilter::SummedArea:
        return witness.told(3, filter_summed_area(unit, fragment, quad, witness));
    case TextureFilter::Elliptic:
        return witness.told(3, filter_elliptic(unit, fragment, quad, witness));
    default:
        return witness.told(3, filter_bicubic(unit, fragment, witness));
    }
}

std::array<std::int32_t, 4> bicubic_weights(std::uint32_t weight) {
    // Keys' cubics at n / 256, twice, have the denominator 2^24; 2^-10 of it is 2^15.
    const auto n = static_cast<std::int32_t>(weight);
    const auto rounded = [](std::int32_t value) { return (value + (1 << 14)) >> 15; };
    const std::int32_t before = rounded(-n * n * n + 512 * n * n - 65536 * n);
    const std::int32_t second = rounded(-3 * n * n * n + 1024 * n * n + 65536 * n);
    const std::int32_t after = rounded(n * n * n - 256 * n * n);
    return {before, 1024 - before - second - after, second, after};
}

Rgba filter_bicubic(const TextureUnit& unit,
                    const SampledFragment& fragment,
                    const FilterWitness& witness) {
    const std::array<float, 2> coords{fragment.coord.s, fragment.coord.t};
    std::array<std::int32_t, 2> first{};
    std::array<std::array<std::int32_t, 4>, 2> weights{};
    for (unsigned axis = 0; axis < 2; ++axis) {
        const std::int32_t from_centre =
            texel_position(unit.sampler.wrap[axis], coords[axis], unit.size[axis]) - 128;
        first[axis] = (from_centre >> 8) - 1;
        weights[axis] = bicubic_weights(static_cast<std::uint32_t>(from_centre & 0xff));
    }
    const TexelBlock block(unit, 0, witness);
    std::array<std::int32_t, 4> sum{};
    for (unsigned y = 0; y < 4; y += 2)
        for (unsigned x = 0; x < 4; x += 2) {
            std::array<std::int32_t, 4> products{};
            for (unsigned i = 0; i < 4; ++i)
                products[i] = weights[0][x + i % 2] * weights[1][y + i / 2];
            const std::array<Rgba, 4> texels = block.read(first[0] + static_cast<std::int32_t>(x),
                                                          first[1] + static_cast<std::int32_t>(y),
                                                          products);
            for (unsigned i = 0; i < 4; ++i)
                for (unsigned channel = 0; channel < 4; ++channel)
                    sum[channel] += products[i] * texels[i][channel];
        }
    Rgba color{};
    for (unsigned channel = 0; channel < 4; ++channel)
        color[channel] =
            static_cast<std::uint8_t>(std::clamp((sum[channel] + (1 << 19)) >> 20, 0, 255));
    return color;
}

} // namespace ffgpu
