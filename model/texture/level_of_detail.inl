// The level of detail over lanes of quads: FFGPU_LANES has Floats and Integers and their
// operations. Plain numbers make it the specification, vectors what runs.

namespace ffgpu::FFGPU_LANES {
namespace {

// GL 1.5, equation 3.17, squared; the bits of a binary32 number.
inline Integers squared_length(const TextureUnit& unit, const Floats* step) {
    Floats sum = splat(0);
    for (unsigned axis = 0; axis < unit.dimensions; ++axis) {
        const Floats any = absolute(step[axis] * splat(unit.density[axis]));
        const Floats texels = minimum(maximum(any, splat(LeastStep)), splat(LargestStep));
        const Floats square = texels * texels;
        sum = axis == 0 ? square : sum + square;
    }
    return bits_of(sum);
}

// log2_fixed8_bits() of binary32 numbers that are not negative.
inline Integers logarithm(Integers bits) {
    const Integers exponent = shift_right<23>(bits) - splat_integer(127);
    return shift_left<8>(exponent) + log2_entry(shift_right<15>(bits) & splat_integer(0xff));
}

inline Integers probes_between(Integers x_logarithm, Integers y_logarithm, unsigned most) {
    const Integers shorter = maximum(minimum(x_logarithm, y_logarithm), splat_integer(0));
    const Integers longer = maximum(x_logarithm, y_logarithm) - shorter;
    Integers probes = splat_integer(1);
    for (unsigned n = 1; n < most; ++n)
        probes = one_more_where_greater(probes, longer, splat_integer(ProbeLogarithms[n]));
    return probes;
}

inline Integers hold(Integers value, std::int32_t low, std::int32_t high) {
    return minimum(maximum(value, splat_integer(low)), splat_integer(high));
}

// Half of the square's logarithm, rounded down, biased and clamped.
inline Integers lambda_of(const TextureUnit& unit, Integers square_logarithm) {
    const Integers lambda = shift_right<1>(square_logarithm) + splat_integer(unit.sampler.bias);
    return hold(lambda, unit.sampler.min_lod, unit.sampler.max_lod);
}

inline Integers filter_bit(bool linear) {
    return splat_integer(linear ? static_cast<std::int32_t>(SamplingBatch::LinearBit) : 0);
}

// GL 1.5, 3.8.8, in the words of SamplingBatch.
inline Integers minified_choice(const TextureUnit& unit, Integers lambda) {
    const auto last = static_cast<std::int32_t>(unit.last_level);
    const Integers linear = filter_bit(unit.sampler.minify_linear);
    if (unit.sampler.mip_filter == MipFilter::None) return linear;
    if (unit.sampler.mip_filter == MipFilter::Nearest) {
        // ceil(lambda + 1/2) - 1: halves go to the finer level.
        return linear | hold(shift_right<8>(lambda + splat_integer(127)), 0, last);
    }
    const Integers level = hold(shift_right<8>(lambda), 0, last);
    const Integers next = minimum(level + splat_integer(1), splat_integer(last));
    const Integers weight = where_greater(
        splat_integer(last), level, lambda & splat_integer(0xff), splat_integer(0));
    return linear | level | shift_left<8>(next) | shift_left<16>(weight);
}

// GL 1.5, 3.8.9.
inline Integers choice_of(const TextureUnit& unit, Integers lambda) {
    return where_greater(lambda,
                         splat_integer(unit.magnify_limit),
                         minified_choice(unit, lambda),
                         filter_bit(unit.sampler.magnify_linear));
}

} // namespace
} // namespace ffgpu::FFGPU_LANES
