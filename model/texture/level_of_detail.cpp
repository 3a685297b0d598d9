#include "model/texture/level_of_detail.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ffgpu {
namespace {

std::uint32_t squared_length(const TextureUnit& unit, const std::array<float, 3>& step) {
    float sum = 0;
    for (unsigned axis = 0; axis < unit.dimensions; ++axis) {
        const float texels =
            std::clamp(std::fabs(step[axis] * unit.density[axis]), LeastStep, LargestStep);
        const float square = texels * texels;
        sum = axis == 0 ? square : sum + square;
    }
    return std::bit_cast<std::uint32_t>(sum);
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
    const std::int32_t x = log2_fixed8_bits(footprint.x), y = log2_fixed8_bits(footprint.y);
    const std::int32_t longer = std::max(x, y) - std::max(std::min(x, y), 0);
    unsigned probes = 1;
    while (probes < most && longer > ProbeLogarithms[probes])
        ++probes;
    return probes;
}

std::int32_t
level_of_detail(const TextureUnit& unit, const PixelFootprint& footprint, unsigned probes) {
    const std::int32_t longer = log2_fixed8_bits(std::max(footprint.x, footprint.y));
    // Half of the square's logarithm, rounded down.
    const std::int32_t lambda = ((longer - ProbeLogarithms[probes]) >> 1) + unit.sampler.bias;
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
