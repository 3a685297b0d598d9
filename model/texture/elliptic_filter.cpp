// The elliptic weighted average.

#include "model/texture/gaussian_weights.h"
#include "model/texture/weighted_mean.h"
#include "model/texture/wide_filters.h"
#include "model/texture/wide_texels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ffgpu {
namespace {

constexpr float LongestSide = 32; // texels of the level

// Q / F = a U^2 + b U V + c V^2; half its width and height, in 256ths of a texel.
struct Ellipse {
    float a = 0, b = 0, c = 0;
    std::array<std::int32_t, 2> half{};
};

Ellipse ellipse_of(const TexelSteps& steps) {
    const auto& [ux, vx] = steps.x;
    const auto& [uy, vy] = steps.y;
    const float a = vx * vx + vy * vy + 1;
    const float b = -2 * (ux * vx + uy * vy);
    const float c = ux * ux + uy * uy + 1;
    const float area = ux * vy - uy * vx;
    const float f = area * area + a + c - 1; // a c - b^2 / 4, without cancellation
    const auto half = [](float square) {
        return static_cast<std::int32_t>(std::sqrt(square) * 256) + 1;
    };
    return {a / f, b / f, c / f, {half(c), half(a)}};
}

// Of the texel whose centre lies (u, v) 256ths of a texel from the ellipse's.
std::int32_t weight_of(const Ellipse& ellipse, std::int32_t u, std::int32_t v) {
    const float at_u = static_cast<float>(u) * 0x1p-8f, at_v = static_cast<float>(v) * 0x1p-8f;
    const float q = (ellipse.a * at_u + ellipse.b * at_v) * at_u + ellipse.c * at_v * at_v;
    return q < 1 ? static_cast<std::int32_t>(gaussian_weight(q)) : 0;
}

unsigned level_of(const TextureUnit& unit, std::int32_t lambda) {
    if (unit.sampler.mip_filter == MipFilter::None) return 0;
    return static_cast<unsigned>(
        std::clamp(lambda >> 8, 0, static_cast<std::int32_t>(unit.last_level)));
}

} // namespace

// Block by block of 2 x 2 texels, from the first of the ellipse's bounding box; a block without a
// texel in the ellipse is not read.
Rgba filter_elliptic(const TextureUnit& unit,
                     const SampledFragment& fragment,
                     const QuadSampling& quad,
                     const FilterWitness& witness) {
    const unsigned level = level_of(unit, quad.lambda);
    const Ellipse ellipse = ellipse_of(texel_steps(unit, quad, level, LongestSide));
    const std::array<float, 2> coords{fragment.coord.s, fragment.coord.t};
    std::array<std::int32_t, 2> from_centre{}, first{}, last{};
    for (unsigned axis = 0; axis < 2; ++axis) {
        from_centre[axis] =
            texel_position(unit.sampler.wrap[axis], coords[axis], level_extent(unit, axis, level)) -
            128;
        first[axis] = (from_centre[axis] - ellipse.half[axis]) >> 8;
        last[axis] = (from_centre[axis] + ellipse.half[axis]) >> 8;
    }
    const TexelBlock block(unit, level, witness);
    WeightedMean sum;
    for (std::int32_t y = first[1]; y <= last[1]; y += 2)
        for (std::int32_t x = first[0]; x <= last[0]; x += 2) {
            std::array<std::int32_t, 4> weights{};
            for (std::int32_t i = 0; i < 4; ++i)
                weights[static_cast<unsigned>(i)] = weight_of(ellipse,
                                                              256 * (x + i % 2) - from_centre[0],
                                                              256 * (y + i / 2) - from_centre[1]);
            if (weights == std::array<std::int32_t, 4>{}) continue;
            const std::array<Rgba, 4> texels = block.read(x, y, weights);
            for (unsigned i = 0; i < 4; ++i)
                sum.add(texels[i], static_cast<std::uint32_t>(weights[i]));
        }
    return sum.mean();
}

} // namespace ffgpu
