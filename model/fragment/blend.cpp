#include "model/fragment/blend.h"

#include "model/fragment/unorm8.h"

#include <algorithm>

namespace ffgpu {
namespace {

struct BlendInputs {
    PixelColor source, destination, constant;
};

// The factor of one channel, 0 .. 255.
std::int32_t factor_value(BlendFactor factor, unsigned channel, const BlendInputs& in) {
    const auto of = [&](const PixelColor& color, unsigned c) -> std::int32_t { return color[c]; };
    switch (factor) {
    case BlendFactor::Zero:
        return 0;
    case BlendFactor::One:
        return 255;
    case BlendFactor::SourceColor:
        return of(in.source, channel);
    case BlendFactor::OneMinusSourceColor:
        return 255 - of(in.source, channel);
    case BlendFactor::DestinationColor:
        return of(in.destination, channel);
    case BlendFactor::OneMinusDestinationColor:
        return 255 - of(in.destination, channel);
    case BlendFactor::SourceAlpha:
        return of(in.source, 3);
    case BlendFactor::OneMinusSourceAlpha:
        return 255 - of(in.source, 3);
    case BlendFactor::DestinationAlpha:
        return of(in.destination, 3);
    case BlendFactor::OneMinusDestinationAlpha:
        return 255 - of(in.destination, 3);
    case BlendFactor::ConstantColor:
        return of(in.constant, channel);
    case BlendFactor::OneMinusConstantColor:
        return 255 - of(in.constant, channel);
    case BlendFactor::ConstantAlpha:
        return of(in.constant, 3);
    case BlendFactor::OneMinusConstantAlpha:
        return 255 - of(in.constant, 3);
    case BlendFactor::SourceAlphaSaturate:
        return channel == 3 ? 255 : std::min(of(in.source, 3), 255 - of(in.destination, 3));
    }
    return 0;
}

std::uint8_t blend_channel(BlendEquation equation,
                           std::int32_t source,
                           std::int32_t source_factor,
                           std::int32_t destination,
                           std::int32_t destination_factor) {
    const std::int32_t s = source * source_factor;
    const std::int32_t d = destination * destination_factor;
    switch (equation) {
    case BlendEquation::Add:
        return unorm8_from_product(s + d);
    case BlendEquation::Subtract:
        return unorm8_from_product(s - d);
    case BlendEquation::ReverseSubtract:
        return unorm8_from_product(d - s);
    case BlendEquation::Min:
        return static_cast<std::uint8_t>(std::min(source, destination));
    case BlendEquation::Max:
        return static_cast<std::uint8_t>(std::max(source, destination));
    }
    return unorm8_from_product(s + d);
}

} // namespace

PixelColor blend(const Blend& state, PixelColor source, PixelColor destination) {
    const BlendInputs in{source, destination, unpack_rgba8(state.constant)};
    PixelColor result{};
    for (unsigned channel = 0; channel < 4; ++channel) {
        const bool alpha = channel == 3;
        result[channel] = blend_channel(
            alpha ? state.alpha_equation : state.rgb_equation,
            source[channel],
            factor_value(alpha ? state.alpha_source : state.rgb_source, channel, in),
            destination[channel],
            factor_value(alpha ? state.alpha_destination : state.rgb_destination, channel, in));
    }
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
