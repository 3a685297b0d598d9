// The level of detail of one quad, its specification.

#include "model/texture/level_of_detail.h"

#include "model/texture/sampling_batch.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace ffgpu::one_quad {
namespace {

using Floats = float;
using Integers = std::int32_t;

Floats splat(float value) {
    return value;
}
Integers splat_integer(std::int32_t value) {
    return value;
}
Floats absolute(Floats a) {
    return std::fabs(a);
}
template <class Number>
Number minimum(Number a, Number b) {
    return std::min(a, b);
}
template <class Number>
Number maximum(Number a, Number b) {
    return std::max(a, b);
}
Integers bits_of(Floats a) {
    return std::bit_cast<Integers>(a);
}
template <int Bits>
Integers shift_left(Integers a) {
    return a * (Integers{1} << Bits);
}
template <int Bits>
Integers shift_right(Integers a) {
    return a >> Bits;
}
Integers log2_entry(Integers at) {
    return Log2Table[static_cast<std::size_t>(at)];
}
Integers where_greater(Integers a, Integers b, Integers yes, Integers no) {
    return a > b ? yes : no;
}
Integers one_more_where_greater(Integers value, Integers a, Integers b) {
    return a > b ? value + 1 : value;
}

} // namespace
} // namespace ffgpu::one_quad

#define FFGPU_LANES one_quad
#include "model/texture/level_of_detail.inl"

namespace ffgpu {
namespace {

CoordinateSteps coordinate_steps(const std::array<TexCoord, 4>& lanes) {
    const auto difference = [](const TexCoord& a, const TexCoord& b) {
        return std::array<float, 3>{a.s - b.s, a.t - b.t, a.r - b.r};
    };
    return {difference(lanes[1], lanes[0]), difference(lanes[2], lanes[0])};
}

std::int32_t logarithm(std::uint32_t bits) {
    return one_quad::logarithm(static_cast<std::int32_t>(bits));
}

} // namespace

PixelFootprint pixel_footprint(const TextureUnit& unit, const CoordinateSteps& steps) {
    const auto square = [&unit](const std::array<float, 3>& step) {
        return static_cast<std::uint32_t>(one_quad::squared_length(unit, step.data()));
    };
    return {square(steps.x), square(steps.y)};
}

unsigned count_probes(const PixelFootprint& footprint, unsigned most) {
    return static_cast<unsigned>(
        one_quad::probes_between(logarithm(footprint.x), logarithm(footprint.y), most));
}

std::int32_t
level_of_detail(const TextureUnit& unit, const PixelFootprint& footprint, unsigned probes) {
    const std::int32_t longer = logarithm(std::max(footprint.x, footprint.y));
    return one_quad::lambda_of(unit, longer - ProbeLogarithms[probes]);
}

QuadSampling choose_levels(const TextureUnit& unit, std::int32_t lambda) {
    const auto choice = static_cast<std::uint32_t>(one_quad::choice_of(unit, lambda));
    QuadSampling result;
    result.level = static_cast<std::uint8_t>(choice);
    result.next_level = static_cast<std::uint8_t>(choice >> 8);
    result.weight = static_cast<std::uint8_t>(choice >> 16);
    result.linear = (choice & SamplingBatch::LinearBit) != 0;
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
