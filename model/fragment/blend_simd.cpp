#include "model/base/simd_targets.h"
#include "model/fragment/blend.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/fragment/blend_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "model/fragment/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

struct Color {
    V16 channels[4];
};

HWY_INLINE Color load_planes(const ColorPlanes& planes, unsigned lane) {
    const D16 d;
    return {{hn::Load(d, planes.r.data() + lane),
             hn::Load(d, planes.g.data() + lane),
             hn::Load(d, planes.b.data() + lane),
             hn::Load(d, planes.a.data() + lane)}};
}

// A word is two halves of 16 bits: r and g, b and a.
HWY_INLINE std::uint16_t* halves(LaneWords& words, unsigned lane) {
    return reinterpret_cast<std::uint16_t*>(words.data() + lane);
}

HWY_INLINE Color load_words(LaneWords& words, unsigned lane) {
    V16 rg, ba;
    hn::LoadInterleaved2(D16(), halves(words, lane), rg, ba);
    const V16 low = set16(255);
    return {{hn::And(rg, low), hn::ShiftRight<8>(rg), hn::And(ba, low), hn::ShiftRight<8>(ba)}};
}

HWY_INLINE void store_words(const Color& color, LaneWords& words, unsigned lane) {
    const V16 rg = hn::Or(color.channels[0], hn::ShiftLeft<8>(color.channels[1]));
    const V16 ba = hn::Or(color.channels[2], hn::ShiftLeft<8>(color.channels[3]));
    hn::StoreInterleaved2(rg, ba, D16(), halves(words, lane));
}

void pack_color_lanes(const FragmentBatch& batch, LaneWords& colors) {
    for (unsigned i = 0; i < batch.lanes(); i += Lanes16)
        store_words(load_planes(batch.color, i), colors, i);
}

// --- Blending -----------------------------------------------------------------------------------

struct Inputs {
    Color source, destination;
    std::uint32_t constant;

    HWY_INLINE V16 constant_channel(unsigned channel) const {
        return set16(constant >> (8 * channel) & 255);
    }
};

HWY_INLINE V16 factor_lanes(BlendFactor factor, unsigned channel, const Inputs& in) {
    const V16(&s)[4] = in.source.channels;
    const V16(&d)[4] = in.destination.channels;
    switch (factor) {
    case BlendFactor::Zero:
        return set16(0);
    case BlendFactor::One:
        return set16(255);
    case BlendFactor::SourceColor:
        return s[channel];
    case BlendFactor::OneMinusSourceColor:
        return complement(s[channel]);
    case BlendFactor::DestinationColor:
        return d[channel];
    case BlendFactor::OneMinusDestinationColor:
        return complement(d[channel]);
    case BlendFactor::SourceAlpha:
        return s[3];
    case BlendFactor::OneMinusSourceAlpha:
        return complement(s[3]);
    case BlendFactor::DestinationAlpha:
        return d[3];
    case BlendFactor::OneMinusDestinationAlpha:
        return complement(d[3]);
    case BlendFactor::ConstantColor:
        return in.constant_channel(channel);
    case BlendFactor::OneMinusConstantColor:
        return complement(in.constant_channel(channel));
    case BlendFactor::ConstantAlpha:
        return in.constant_channel(3);
    case BlendFactor::OneMinusConstantAlpha:
        return complement(in.constant_channel(3));
    case BlendFactor::SourceAlphaSaturate:
        return channel == 3 ? set16(255) : hn::Min(s[3], complement(d[3]));
    }
    return set16(0);
}

// The sum of two products saturates at 65535, beyond the clamp at 65025.
HWY_INLINE V16 combine_products(BlendEquation equation, V16 source, V16 destination) {
    switch (equation) {
    case BlendEquation::Subtract:
        return hn::SaturatedSub(source, destination);
    case BlendEquation::ReverseSubtract:
        return hn::SaturatedSub(destination, source);
    default:
        return hn::SaturatedAdd(source, destination);
    }
}

HWY_INLINE V16 blend_lanes(BlendEquation equation,
                           BlendFactor source_factor,
                           BlendFactor destination_factor,
                           unsigned channel,
                           const Inputs& in) {
    const V16 s = in.source.channels[channel], d = in.destination.channels[channel];
    if (equation == BlendEquation::Min) return hn::Min(s, d);
    if (equation == BlendEquation::Max) return hn::Max(s, d);
    const V16 source = hn::Mul(s, factor_lanes(source_factor, channel, in));
    const V16 destination = hn::Mul(d, factor_lanes(destination_factor, channel, in));
    return clamp_and_divide_by_255(combine_products(equation, source, destination));
}

template <class EachChannel>
HWY_INLINE void
blend_batch(const Blend& state, const FragmentBatch& batch, LaneWords& colors, EachChannel&& each) {
    for (unsigned i = 0; i < batch.lanes(); i += Lanes16) {
        const Inputs in{load_planes(batch.color, i), load_words(colors, i), state.constant};
        store_words({{each(0u, in), each(1u, in), each(2u, in), each(3u, in)}}, colors, i);
    }
}

void blend_general(const Blend& state, const FragmentBatch& batch, LaneWords& colors) {
    blend_batch(state, batch, colors, [&](unsigned channel, const Inputs& in) HWY_ATTR {
        if (channel == 3)
            return blend_lanes(
                state.alpha_equation, state.alpha_source, state.alpha_destination, 3, in);
        return blend_lanes(
            state.rgb_equation, state.rgb_source, state.rgb_destination, channel, in);
    });
}

// One pair of factors for all channels, and Add.
template <BlendFactor Source, BlendFactor Destination>
void blend_fixed(const Blend& state, const FragmentBatch& batch, LaneWords& colors) {
    blend_batch(state, batch, colors, [](unsigned channel, const Inputs& in) HWY_ATTR {
        return blend_lanes(BlendEquation::Add, Source, Destination, channel, in);
    });
}

struct FixedKernel {
    BlendFactor source, destination;
    BlendKernel kernel;
};

template <BlendFactor Source, BlendFactor Destination>
constexpr FixedKernel fixed_kernel() {
    return {Source, Destination, blend_fixed<Source, Destination>};
}

// What programs of the time blend with: translucency, glows, light maps and their like.
constexpr FixedKernel FixedKernels[] = {
    fixed_kernel<BlendFactor::SourceAlpha, BlendFactor::OneMinusSourceAlpha>(),
    fixed_kernel<BlendFactor::SourceAlpha, BlendFactor::One>(),
    fixed_kernel<BlendFactor::One, BlendFactor::One>(),
    fixed_kernel<BlendFactor::One, BlendFactor::OneMinusSourceAlpha>(),
    fixed_kernel<BlendFactor::One, BlendFactor::OneMinusSourceColor>(),
    fixed_kernel<BlendFactor::DestinationColor, BlendFactor::Zero>(),
    fixed_kernel<BlendFactor::Zero, BlendFactor::SourceColor>(),
    fixed_kernel<BlendFactor::DestinationColor, BlendFactor::SourceColor>(),
    fixed_kernel<BlendFactor::Zero, BlendFactor::OneMinusSourceColor>(),
};

BlendKernel choose_kernel(const Blend& state) {
    const bool uniform =
        state.rgb_equation == BlendEquation::Add && state.alpha_equation == BlendEquation::Add &&
        state.rgb_source == state.alpha_source && state.rgb_destination == state.alpha_destination;
    if (uniform)
        for (const FixedKernel& fixed : FixedKernels)
            if (fixed.source == state.rgb_source && fixed.destination == state.rgb_destination)
                return fixed.kernel;
    return blend_general;
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(pack_color_lanes);
HWY_EXPORT(choose_kernel);

void pack_color(const FragmentBatch& batch, LaneWords& colors) {
    HWY_DYNAMIC_DISPATCH(pack_color_lanes)(batch, colors);
}

void apply_logic_op(LogicOp op, const LaneWords& source, LaneWords& destination, unsigned lanes) {
    const std::uint32_t* s = source.data();
    std::uint32_t* d = destination.data();
    for (unsigned i = 0; i < lanes; ++i)
        d[i] = apply_logic_op(op, s[i], d[i]);
}

BlendKernel choose_blend_kernel(const Blend& state) {
    return HWY_DYNAMIC_DISPATCH(choose_kernel)(state);
}

} // namespace ffgpu
#endif
