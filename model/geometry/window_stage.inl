// Clip codes, the division by w and the viewport (GL 1.5, 2.11, 2.12).
//
// A vertex that some plane cuts off gets window coordinates as well, clamped numbers without
// meaning: no primitive uses them.

namespace ffgpu::FFGPU_LANES {

inline Integers code_where(Mask mask, ClipCode code) {
    return zero_unless(mask, splat_integer(static_cast<std::int32_t>(code)));
}

// True for NaN as well.
inline Mask too_large(Floats sum_of_magnitudes) {
    return !(sum_of_magnitudes < splat(LargestMagnitude));
}

inline Integers view_codes(const Floats4& clip, const WindowSetup& window) {
    using namespace clip_code;
    const auto [x, y, z, w] = clip;
    const Floats minus_w = negate(w);
    const Mask sides = (x < splat(window.low_x) * w) | (x > splat(window.high_x) * w) |
                       (y < splat(window.low_y) * w) | (y > splat(window.high_y) * w);
    const Floats sum = (absolute(x) + absolute(y)) + (absolute(z) + absolute(w));
    return ((code_where(x < minus_w, Left) | code_where(x > w, Right)) |
            (code_where(y < minus_w, Bottom) | code_where(y > w, Top))) |
           ((code_where(z < minus_w, window.near_code) | code_where(z > w, window.far_code)) |
            (code_where(sides, Sides) | code_where(w < splat(LeastW), SmallW))) |
           code_where(too_large(sum), Invalid);
}

inline Integers user_codes(const UserClipPlanes& planes, const Floats4& eye) {
    using namespace clip_code;
    const Floats sum =
        (absolute(eye[0]) + absolute(eye[1])) + (absolute(eye[2]) + absolute(eye[3]));
    Integers codes = code_where(too_large(sum), Invalid);
    for (unsigned plane = 0; plane < ClipPlanes; ++plane) {
        if (!(planes.enable >> plane & 1)) continue;
        const Floats distance = dot(planes.planes[plane], eye);
        codes = codes | code_where(distance < splat(0.0f), 1u << (FirstUserBit + plane)) |
                code_where(too_large(absolute(distance)), Invalid);
    }
    return codes;
}

// 24.8, rounded to nearest even, within the guard band.
inline Integers snap(Floats pixels) {
    constexpr float Limit = GuardBand * (1 << SubPixelBits);
    const Floats scaled = pixels * splat(float{1 << SubPixelBits});
    const Floats clamped = minimum(maximum(scaled, splat(-Limit)), splat(Limit));
    return bits_of(clamped + splat(log_exp::RoundToInteger)) -
           bits_of(splat(log_exp::RoundToInteger));
}

inline void window_stage(const VertexSetup& setup, VertexBatch& batch) {
    const UserClipPlanes& planes = setup.registers->clip_planes;
    const auto& [scale, offset] = std::tie(setup.window.scale, setup.window.offset);
    for (unsigned lane = 0; lane < batch.count; lane += LaneCount) {
        const Floats4 clip = load4(batch.clip, lane);
        Integers codes = view_codes(clip, setup.window);
        if (planes.enable != 0) codes = codes | user_codes(planes, load4(batch.eye, lane));
        store_integers(codes, &batch.codes[lane]);

        const auto [x, y, z, w] = clip;
        const Floats window_x = splat(scale[0]) * (x / w) + splat(offset[0]);
        const Floats window_y = splat(scale[1]) * (y / w) + splat(offset[1]);
        const Floats depth = splat(scale[2]) * (z / w) + splat(offset[2]);
        store(from_bits(snap(window_x)), batch.window[0].at(lane));
        store(from_bits(snap(window_y)), batch.window[1].at(lane));
        store(
            minimum(maximum(depth, splat(setup.window.low_depth)), splat(setup.window.high_depth)),
            batch.window[2].at(lane));
        store(splat(1.0f) / w, batch.window[3].at(lane));
    }
}

} // namespace ffgpu::FFGPU_LANES
