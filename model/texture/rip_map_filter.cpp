// Filtering from a rip-map.

#include "model/texture/wide_filters.h"
#include "model/texture/wide_texels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ffgpu {
namespace {

// The two images of an axis and the second's weight in 256ths.
struct RipAxis {
    std::uint32_t level = 0;
    std::uint32_t weight = 0;
};

// What a pixel covers along the axis, as 2^-8 of a logarithm; 0 where it covers a texel or less.
RipAxis rip_axis(const TextureUnit& unit, unsigned axis, const QuadSampling& quad) {
    const float covered = std::max(std::fabs(quad.steps.x[axis]), std::fabs(quad.steps.y[axis]));
    const float texels = std::clamp(covered * unit.density[axis], LeastStep, LargestStep);
    const std::int32_t lambda = std::clamp<std::int32_t>(
        log2_fixed8(texels) + unit.sampler.bias, unit.sampler.min_lod, unit.sampler.max_lod);
    const auto last =
        static_cast<std::int32_t>(rip_levels(static_cast<std::uint32_t>(unit.size[axis])) - 1);
    const std::int32_t fixed = std::clamp(lambda, 0, 256 * last);
    return {static_cast<std::uint32_t>(fixed >> 8), static_cast<std::uint32_t>(fixed & 0xff)};
}

// Texels of one of the images, along one axis: of the image, and of the whole.
AxisTexels
image_texels(const TextureUnit& unit, unsigned axis, std::uint32_t level, float s, bool linear) {
    const WrapRule& rule = linear ? unit.linear_rules[axis] : unit.nearest_rules[axis];
    const std::int32_t size = level_extent(unit, axis, level);
    const float folded = fold_coordinate(rule.fold, s, 1);
    const std::int32_t at = texel_coordinate(folded, static_cast<float>(256 * size), size, rule);
    return linear ? linear_texels(at, size, rule) : nearest_texel(at, size, rule);
}

// Its images, each a probe of its own.
class RipImages {
public:
    RipImages(const TextureUnit& unit, bool linear, const FilterWitness& witness)
        : unit_(unit)
        , linear_(linear)
        , witness_(witness) {}

    // Bilinear, in the image that is halved `i` times along x and `j` times along y.
    Rgba sample(std::uint32_t i, std::uint32_t j, const SampledFragment& fragment) const {
        const TexCoord& coord = fragment.coord;
        witness_.begin_probe(fragment);
        const std::array<AxisTexels, 3> axes{image_texels(unit_, 0, i, coord.s, linear_),
                                             image_texels(unit_, 1, j, coord.t, linear_),
                                             AxisTexels{}};
        const AxisTexels &x = axes[0], &y = axes[1];
        const std::uint16_t x0 = stored(0, i, x.first), x1 = stored(0, i, x.second);
        const std::uint16_t y0 = stored(1, j, y.first), y1 = stored(1, j, y.second);
        witness_.tell({.lane = static_cast<std::uint16_t>(witness_.lane),
                       .level = 0,
                       .linear = static_cast<std::uint8_t>(linear_ ? 3 : 0),
                       .x0 = x0,
                       .x1 = x1,
                       .y0 = y0,
                       .y1 = y1,
                       .layer0 = 0,
                       .layer1 = 0},
                      axes);
        const Rgba first = row(x0, x1, y0, x.weight);
        const Rgba both = linear_ ? lerp8w(first, row(x0, x1, y1, x.weight), y.weight) : first;
        return witness_.told(3, witness_.told(2, witness_.told(1, both)));
    }

private:
    std::uint16_t stored(unsigned axis, std::uint32_t level, std::int32_t index) const {
        if (index < 0 || index >= level_extent(unit_, axis, level)) return TexelAccess::BorderTexel;
        const auto size = static_cast<std::uint32_t>(unit_.size[axis]);
        return static_cast<std::uint16_t>(rip_offset(size, level) +
                                          static_cast<std::uint32_t>(index));
    }

    Rgba row(std::uint16_t x0, std::uint16_t x1, std::uint16_t y, std::uint32_t weight) const {
        const Rgba first = read_stored_texel(unit_, {.x = x0, .y = y}, witness_.observer);
        if (!linear_) return witness_.told(0, first);
        const Rgba second = read_stored_texel(unit_, {.x = x1, .y = y}, witness_.observer);
        return witness_.told(0, lerp8w(first, second, weight));
    }

    const TextureUnit& unit_;
    const bool linear_;
    const FilterWitness witness_;
};

} // namespace

Rgba filter_rip_map(const TextureUnit& unit,
                    const SampledFragment& fragment,
                    const QuadSampling& quad,
                    const FilterWitness& witness) {
    const RipAxis u = rip_axis(unit, 0, quad), v = rip_axis(unit, 1, quad);
    // Image (i, j) of the four, with its weight in 2^-16.
    const auto image = [&](std::uint32_t i, std::uint32_t j) {
        const std::uint32_t weight =
            (i == 0 ? 256 - u.weight : u.weight) * (j == 0 ? 256 - v.weight : v.weight);
        return RipImages(unit, quad.linear, witness.weighted(weight))
            .sample(u.level + i, v.level + j, fragment);
    };
    const auto along_u = [&](std::uint32_t j) {
        const Rgba fine = image(0, j);
        return u.weight == 0 ? fine : lerp8w(fine, image(1, j), u.weight);
    };
    const Rgba fine = along_u(0);
    return v.weight == 0 ? fine : lerp8w(fine, along_u(1), v.weight);
}

} // namespace ffgpu
