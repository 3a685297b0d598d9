#include "model/fragment/fog.h"

#include "model/arith/exp2.h"
#include "model/arith/range.h"
#include "model/fragment/lane_access.h"
#include "model/fragment/unorm8.h"

namespace ffgpu {

FogCurve compile_fog(const Fog& fog) {
    const float end = in_fog_range(fog.end), start = in_fog_range(fog.start);
    const float density = in_fog_range(fog.density);
    FogCurve curve{.mode = fog.mode, .end = end, .scale = 1, .color = unpack_rgba8(fog.color)};
    switch (fog.mode) {
    case FogMode::Off:
        break;
    case FogMode::Linear:
        curve.scale = end == start ? LargestValue : 1.0f / (end - start);
        break;
    case FogMode::Exp:
        curve.scale = density * Log2E;
        break;
    case FogMode::Exp2:
        curve.scale = density;
        break;
    }
    return curve;
}

std::uint8_t fog_factor(const FogCurve& curve, float coordinate) {
    if (curve.mode == FogMode::Linear)
        return unorm8_from_float((curve.end - coordinate) * curve.scale);
    float exponent = coordinate * curve.scale;
    if (curve.mode == FogMode::Exp2) exponent = exponent * exponent * Log2E;
    if (!(exponent < FogExponentLimit)) return 0;
    if (!(exponent > 0.0f)) return 255;
    const auto fixed = static_cast<std::uint32_t>(exponent * 65536.0f + 0.5f);
    return static_cast<std::uint8_t>(exp2_negative_unorm8(fixed));
}

PixelColor apply_fog(const FogCurve& curve, std::uint8_t factor, PixelColor color) {
    for (unsigned channel = 0; channel < 3; ++channel)
        color[channel] = static_cast<std::uint8_t>(
            divide_255(factor * color[channel] + (Unorm8One - factor) * curve.color[channel]));
    return color;
}

void apply_fog_scalar(const FogCurve& curve, FragmentBatch& batch) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane)
        set_lane_color(batch.color,
                       lane,
                       apply_fog(curve,
                                 fog_factor(curve, batch.fog_coordinate[lane]),
                                 lane_color(batch.color, lane)));
}

} // namespace ffgpu
