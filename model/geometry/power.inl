// model/arith/power.h over lanes: the same operations in the same order.

namespace ffgpu::FFGPU_LANES {

// x: positive, not subnormal, finite.
inline Floats log2_lanes(Floats x) {
    using namespace log_exp;
    const Integers bits = bits_of(x);
    const Integers exponent = shift_right<23>(bits) - splat_integer(127);
    const Integers mantissa = bits & splat_integer(0x7fffff);
    const Integers i = shift_right<17>(mantissa + splat_integer(1 << 16));
    const Floats m = from_bits(mantissa | splat_integer(0x3f800000));
    const Floats c = to_floats(i) * splat(Step) + splat(1.0f);
    const Floats z = (m - c) * gather(Reciprocal.data(), i);
    const Floats head = to_floats(exponent) + gather(Log2.data(), i);
    return head + z * (splat(K1) + z * (splat(K2) + z * splat(K3)));
}

// v in [-126, 127].
inline Floats exp2_lanes(Floats v) {
    using namespace log_exp;
    const Floats biased = v * splat(float{LogExpSegments}) + splat(RoundToInteger);
    const Integers k = bits_of(biased) - bits_of(splat(RoundToInteger));
    const Floats r = v - to_floats(k) * splat(Step);
    const Floats table = gather(Exp2.data(), k & splat_integer(LogExpSegments - 1));
    const Floats scale = from_bits(shift_left<23>(shift_right<6>(k) + splat_integer(127)));
    return table * (splat(1.0f) + r * (splat(E1) + r * splat(E2))) * scale;
}

inline Floats power_lanes(Floats x, Floats y) {
    using namespace log_exp;
    const Floats base = minimum(maximum(x, splat(LeastBase)), splat(GreatestBase));
    const Floats exponent = y * log2_lanes(base);
    const Floats clamped = minimum(maximum(exponent, splat(LeastPower)), splat(GreatestPower));
    const Mask counts = (x > splat(0.0f)) | (y == splat(0.0f));
    return zero_unless(counts & (exponent >= splat(LeastPower)), exp2_lanes(clamped));
}

} // namespace ffgpu::FFGPU_LANES
