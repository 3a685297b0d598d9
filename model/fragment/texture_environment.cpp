#include "model/fragment/texture_environment.h"

#include "model/fragment/lane_access.h"
#include "model/fragment/unorm8.h"

#include <algorithm>

namespace ffgpu {
namespace {

using Arguments = std::array<std::int32_t, 4>;

constexpr std::int32_t One = 255;
constexpr std::int32_t OneSquared = One * One;

PixelColor source_color(CombineSource source, const Combiner& combiner, const CombineInputs& in) {
    const auto index = static_cast<unsigned>(source);
    if (index < TextureUnits) return in.texture[index];
    switch (source) {
    case CombineSource::Constant:
        return unpack_rgba8(combiner.constant);
    case CombineSource::Primary:
        return in.primary;
    case CombineSource::Previous:
        return in.previous;
    case CombineSource::One:
        return {255, 255, 255, 255};
    default:
        return {0, 0, 0, 0};
    }
}

std::int32_t argument_value(const CombineArgument& argument,
                            unsigned channel,
                            const Combiner& combiner,
                            const CombineInputs& in) {
    const PixelColor color = source_color(argument.source, combiner, in);
    switch (argument.operand) {
    case CombineOperand::Color:
        return color[channel];
    case CombineOperand::OneMinusColor:
        return One - color[channel];
    case CombineOperand::Alpha:
        return color[3];
    case CombineOperand::OneMinusAlpha:
        return One - color[3];
    }
    return 0;
}

Arguments channel_arguments(const CombineHalf& half,
                            unsigned channel,
                            const Combiner& combiner,
                            const CombineInputs& in) {
    Arguments values{};
    for (unsigned i = 0; i < values.size(); ++i)
        values[i] = argument_value(half.arguments[i], channel, combiner, in);
    return values;
}

// Twice the exact result, in units of 1 / 65025. The factor 2 keeps the halves of the signed
// operations whole.
std::int32_t doubled_result(CombineOp op, const Arguments& a) {
    switch (op) {
    case CombineOp::Modulate:
        return 2 * a[0] * a[1];
    case CombineOp::Add:
        return 2 * One * (a[0] + a[1]);
    case CombineOp::AddSigned:
        return 2 * One * (a[0] + a[1]) - OneSquared;
    case CombineOp::Interpolate:
        return 2 * (a[0] * a[2] + a[1] * (One - a[2]));
    case CombineOp::Subtract:
        return 2 * One * (a[0] - a[1]);
    case CombineOp::ModulateAdd:
        return 2 * (a[0] * a[2] + One * a[1]);
    case CombineOp::ModulateSignedAdd:
        return 2 * (a[0] * a[2] + One * a[1]) - OneSquared;
    case CombineOp::ModulateSubtract:
        return 2 * (a[0] * a[2] - One * a[1]);
    case CombineOp::AddProducts:
        return 2 * (a[0] * a[1] + a[2] * a[3]);
    case CombineOp::AddProductsSigned:
        return 2 * (a[0] * a[1] + a[2] * a[3]) - OneSquared;
    default:
        return 2 * One * a[0];
    }
}

// Scales, clamps, and rounds from units of 1 / (2 * 65025) to 1 / 255: to nearest, ties up.
std::uint8_t finish(std::int32_t doubled, unsigned scale_shift) {
    const std::int32_t scaled = doubled * (1 << std::min(scale_shift, 2u));
    const std::int32_t clamped = std::clamp(scaled, 0, 2 * OneSquared);
    return static_cast<std::uint8_t>((clamped + One) / (2 * One));
}

bool is_dot_product(CombineOp op) {
    return op == CombineOp::Dot3Rgb || op == CombineOp::Dot3Rgba;
}

// Twice 4 sum((a - 1/2)(b - 1/2)) = sum((2a - 1)(2b - 1)).
std::int32_t doubled_dot_product(const Combiner& combiner, const CombineInputs& in) {
    std::int32_t sum = 0;
    for (unsigned channel = 0; channel < 3; ++channel) {
        const Arguments a = channel_arguments(combiner.rgb, channel, combiner, in);
        sum += (2 * a[0] - One) * (2 * a[1] - One);
    }
    return 2 * sum;
}

} // namespace

PixelColor combine(const Combiner& combiner, const CombineInputs& inputs) {
    PixelColor result{};
    if (is_dot_product(combiner.rgb.op)) {
        const std::int32_t doubled = doubled_dot_product(combiner, inputs);
        result.fill(finish(doubled, combiner.rgb.scale_shift));
        if (combiner.rgb.op == CombineOp::Dot3Rgba) {
            result[3] = finish(doubled, combiner.alpha.scale_shift);
            return result;
        }
    } else {
        for (unsigned channel = 0; channel < 3; ++channel) {
            const Arguments a = channel_arguments(combiner.rgb, channel, combiner, inputs);
            result[channel] = finish(doubled_result(combiner.rgb.op, a), combiner.rgb.scale_shift);
        }
    }
    const Arguments a = channel_arguments(combiner.alpha, 3, combiner, inputs);
    result[3] = finish(doubled_result(combiner.alpha.op, a), combiner.alpha.scale_shift);
    return result;
}

void run_environment_scalar(const EnvironmentProgram& program, unsigned i, FragmentBatch& batch) {
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        CombineInputs inputs{};
        for (unsigned unit = 0; unit < TextureUnits; ++unit)
            inputs.texture[unit] = (program.sampled_units >> unit & 1) != 0
                                       ? lane_color(batch.texture[unit], lane)
                                       : UnsampledTexture;
        inputs.primary = lane_color(batch.primary, lane);
        inputs.previous = i == 0 ? inputs.primary : lane_color(batch.color, lane);
        set_lane_color(batch.color, lane, combine(program.units[i].combiner, inputs));
    }
}

} // namespace ffgpu
