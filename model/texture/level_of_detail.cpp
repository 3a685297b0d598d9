#include "model/texture/level_of_detail.h"

#include "model/arith/log2.h"

#include <algorithm>
#include <bit>

namespace ffgpu {
namespace {

constexpr std::uint32_t OneBits = std::bit_cast<std::uint32_t>(1.0f);

// The sign of a NaN differs between processors, so it is dropped.
std::uint32_t magnitude_bits(float x) {
    return std::bit_cast<std::uint32_t>(x) & 0x7fffffff;
}

std::uint32_t squared_length(const TextureUnit& unit, const std::array<float, 3>& step) {
    float sum = 0;
    for (unsigned axis = 0; axis < unit.dimensions; ++axis) {
        const float texels = step[axis] * unit.density[axis];
        const float square = texels * texels;
        sum = axis == 0 ? square : sum + square;
    }
    return magnitude_bits(sum);
}

CoordinateSteps coordinate_steps(const std::array<TexCoord, 4>& lanes) {
    const auto difference = [](const TexCoord& a, const TexCoord& b) {
        return std::array<float, 3>{a.s - b.s, a.t - b.t, a.r - b.r};
    };
    return {difference(lanes[1], lanes[0]), difference(lanes[2], lanes[0])};
}

} // namespace

// GL 1.5, equation 3.17, squared.
PixelFootprint pixel_footprint(const TextureUnit& unit, const CoordinateSteps& steps) {
    return {squared_length(unit, steps.x), squared_length(unit, steps.y)};
}

unsigned count_probes(const PixelFootprint& footprint, unsigned most) {
    const auto longer = std::bit_cast<float>(std::max(footprint.x, footprint.y));
    const auto shorter =
        std::bit_cast<float>(std::max(std::min(footprint.x, footprint.y), OneBits));
    unsigned probes = 1;
    while (probes < most && !(static_cast<float>(probes * probes) * shorter >= longer))
        ++probes;
    return probes;
}

std::int32_t
level_of_detail(const TextureUnit& unit, const PixelFootprint& footprint, unsigned probes) {
    const auto longer = std::bit_cast<float>(std::max(footprint.x, footprint.y));
    const float over_probes = longer / static_cast<float>(probes * probes);
    // Half of the square's logarithm, rounded down.
    const std::int32_t lambda = (log2_fixed8(over_probes) >> 1) + unit.sampler.bias;
    return std::min<std::int32_t>(std::max<std::int32_t>(lambda, unit.sampler.min_lod),
                                  unit.sampler.max_lod);
}

// GL 1.5, 3.8.8 and 3.8.9.
QuadSampling choose_levels(const TextureUnit& unit, std::int32_t lambda) {
    QuadSampling result;
    const auto last = static_cast<std::int32_t>(unit.last_level);
    const bool magnifies = lambda <= unit.magnify_limit;
    result.linear = magnifies ? unit.sampler.magnify_linear : unit.sampler.minify_linear;
    if (magnifies || unit.sampler.mip_filter == MipFilter::None) return result;

    if (unit.sampler.mip_filter == MipFilter::Nearest) {
        // ceil(lambda + 1/2) - 1: halves go to the finer level.
        const std::int32_t nearest = (lambda + 127) >> 8;
        result.level = static_cast<std::uint8_t>(std::clamp(nearest, 0, last));
        return result;
    }
    const std::int32_t level = std::clamp(lambda >> 8, 0, last);
    result.level = static_cast<std::uint8_t>(level);
    result.next_level = static_cast<std::uint8_t>(std::min(level + 1, last));
    if (level < last) result.weight = static_cast<std::uint8_t>(lambda & 0xff);
    return result;
}

QuadSampling
sample_quad(const TextureUnit& unit, const std::array<TexCoord, 4>& lanes, bool one_face) {
    const CoordinateSteps steps = coordinate_steps(lanes);
    const PixelFootprint footprint = pixel_footprint(unit, steps);
    const unsigned probes = one_face ? count_probes(footprint, unit.max_probes) : 1;
    const std::int32_t lambda = level_of_detail(unit, footprint, probes);
    QuadSampling result = choose_levels(unit, lambda);
    result.steps = steps;
    result.footprint = footprint;
    result.lambda = lambda;
    const std::array<float, 3>& major = footprint.x >= footprint.y ? steps.x : steps.y;
    result.probes = static_cast<std::uint8_t>(probes);
    result.major_step = {major[0], major[1], major[2]};
    return result;
}

} // namespace ffgpu
