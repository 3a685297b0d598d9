#include "model/fragment/blend.h"

#include "model/arith/srgb.h"

#include <algorithm>
#include <array>

namespace ffgpu {
namespace {

using Channels = std::array<std::int64_t, 4>;

// Numbers n / one.
struct BlendInputs {
    std::int64_t one;
    Channels source, destination, constant;
};

// The factor of one channel, 0 .. one.
std::int64_t factor_value(BlendFactor factor, unsigned channel, const BlendInputs& in) {
    switch (factor) {
    case BlendFactor::Zero:
        return 0;
    case BlendFactor::One:
        return in.one;
    case BlendFactor::SourceColor:
        return in.source[channel];
    case BlendFactor::OneMinusSourceColor:
        return in.one - in.source[channel];
    case BlendFactor::DestinationColor:
        return in.destination[channel];
    case BlendFactor::OneMinusDestinationColor:
        return in.one - in.destination[channel];
    case BlendFactor::SourceAlpha:
        return in.source[3];
    case BlendFactor::OneMinusSourceAlpha:
        return in.one - in.source[3];
    case BlendFactor::DestinationAlpha:
        return in.destination[3];
    case BlendFactor::OneMinusDestinationAlpha:
        return in.one - in.destination[3];
    case BlendFactor::ConstantColor:
        return in.constant[channel];
    case BlendFactor::OneMinusConstantColor:
        return in.one - in.constant[channel];
    case BlendFactor::ConstantAlpha:
        return in.constant[3];
    case BlendFactor::OneMinusConstantAlpha:
        return in.one - in.constant[3];
    case BlendFactor::SourceAlphaSaturate:
        return channel == 3 ? in.one : std::min(in.source[3], in.one - in.destination[3]);
    }
    return 0;
}

// one is odd: there are no ties.
std::int64_t rounded(std::int64_t product, std::int64_t one) {
    return (std::clamp<std::int64_t>(product, 0, one * one) + one / 2) / one;
}

std::int64_t blend_channel(const Blend& state, unsigned channel, const BlendInputs& in) {
    const bool alpha = channel == 3;
    const BlendFactor source_factor = alpha ? state.alpha_source : state.rgb_source;
    const BlendFactor destination_factor = alpha ? state.alpha_destination : state.rgb_destination;
    const std::int64_t s = in.source[channel] * factor_value(source_factor, channel, in);
    const std::int64_t d = in.destination[channel] * factor_value(destination_factor, channel, in);
    switch (alpha ? state.alpha_equation : state.rgb_equation) {
    case BlendEquation::Add:
        break;
    case BlendEquation::Subtract:
        return rounded(s - d, in.one);
    case BlendEquation::ReverseSubtract:
        return rounded(d - s, in.one);
    case BlendEquation::Min:
        return std::min(in.source[channel], in.destination[channel]);
    case BlendEquation::Max:
        return std::max(in.source[channel], in.destination[channel]);
    }
    return rounded(s + d, in.one);
}

Channels scaled(const PixelColor& color, std::int64_t by) {
    Channels channels{};
    for (unsigned channel = 0; channel < 4; ++channel)
        channels[channel] = color[channel] * by;
    return channels;
}

} // namespace

PixelColor blend(const Blend& state, PixelColor source, PixelColor destination) {
    const BlendInputs in{
        255, scaled(source, 1), scaled(destination, 1), scaled(unpack_rgba8(state.constant), 1)};
    PixelColor result{};
    for (unsigned channel = 0; channel < 4; ++channel)
        result[channel] = static_cast<std::uint8_t>(blend_channel(state, channel, in));
    return result;
}

PixelColor blend_srgb(const Blend& state, PixelColor source, PixelColor destination) {
    BlendInputs in{65535,
                   scaled(source, 257),
                   scaled(destination, 257),
                   scaled(unpack_rgba8(state.constant), 257)};
    for (unsigned channel = 0; channel < 3; ++channel)
        in.destination[channel] = SrgbToLinear16[destination[channel]];
    PixelColor result = blend(state, source, destination); // alpha's
    for (unsigned channel = 0; channel < 3; ++channel)
        result[channel] =
            srgb_encoded16(static_cast<std::uint32_t>(blend_channel(state, channel, in)));
    return result;
}

std::uint32_t apply_logic_op(LogicOp op, std::uint32_t source, std::uint32_t destination) {
    switch (op) {
    case LogicOp::Clear:
        return 0;
    case LogicOp::And:
        return source & destination;
    case LogicOp::AndReverse:
        return source & ~destination;
    case LogicOp::Copy:
        return source;
    case LogicOp::AndInverted:
        return ~source & destination;
    case LogicOp::Noop:
        return destination;
    case LogicOp::Xor:
        return source ^ destination;
    case LogicOp::Or:
        return source | destination;
    case LogicOp::Nor:
        return ~(source | destination);
    case LogicOp::Equiv:
        return ~(source ^ destination);
    case LogicOp::Invert:
        return ~destination;
    case LogicOp::OrReverse:
        return source | ~destination;
    case LogicOp::CopyInverted:
        return ~source;
    case LogicOp::OrInverted:
        return ~source | destination;
    case LogicOp::Nand:
        return ~(source & destination);
    case LogicOp::Set:
        return ~std::uint32_t{0};
    }
    return source;
}

ColorOperation color_operation(const Blend& state) {
    if (state.logic_op_enable)
        return state.logic_op == LogicOp::Copy ? ColorOperation::Replace : ColorOperation::Logic;
    if (!state.enable) return ColorOperation::Replace;
    const bool identity =
        state.rgb_equation == BlendEquation::Add && state.alpha_equation == BlendEquation::Add &&
        state.rgb_source == BlendFactor::One && state.alpha_source == BlendFactor::One &&
        state.rgb_destination == BlendFactor::Zero && state.alpha_destination == BlendFactor::Zero;
    return identity ? ColorOperation::Replace : ColorOperation::Blend;
}

} // namespace ffgpu
