// Vector form of s3tc.h: a block and a texel of it for each lane.
// Included once for each instruction set.

#if defined(FFGPU_MODEL_TEXTURE_S3TC_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_TEXTURE_S3TC_INL_H
#undef FFGPU_MODEL_TEXTURE_S3TC_INL_H
#else
#define FFGPU_MODEL_TEXTURE_S3TC_INL_H
#endif

#include "model/texture/axis-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

HWY_INLINE VU widen5(VU value) {
    return hn::Or(hn::ShiftLeft<3>(value), hn::ShiftRight<2>(value));
}

HWY_INLINE VU expand_rgb565(VU raw) {
    const DU d;
    const VU five = hn::Set(d, 31), six = hn::Set(d, 63);
    const VU r = widen5(hn::And(hn::ShiftRight<11>(raw), five));
    const VU g6 = hn::And(hn::ShiftRight<5>(raw), six);
    const VU g = hn::Or(hn::ShiftLeft<2>(g6), hn::ShiftRight<4>(g6));
    const VU b = widen5(hn::And(raw, five));
    const VU rg = hn::Or(r, hn::ShiftLeft<8>(g));
    return hn::Or(hn::Or(rg, hn::ShiftLeft<16>(b)), hn::Set(d, 0xff000000u));
}

// value / 3, / 5, / 7 rounded down: exact for value <= 2040 (tests/texture proves each).
HWY_INLINE VU third(VU value) {
    return hn::ShiftRight<16>(hn::Mul(value, hn::Set(DU(), 21846)));
}
HWY_INLINE VU fifth(VU value) {
    return hn::ShiftRight<16>(hn::Mul(value, hn::Set(DU(), 13108)));
}
HWY_INLINE VU seventh(VU value) {
    return hn::ShiftRight<16>(hn::Mul(value, hn::Set(DU(), 9363)));
}

HWY_INLINE VU channel(VU color, int lsb) {
    return hn::And(hn::ShiftRightSame(color, lsb), hn::Set(DU(), 0xff));
}

// (wa a + wb b) / 3 or / 2 of one channel, in its place. Per lane wa + wb is 3, or 2 if `halves`.
struct ColorWeights {
    VU a, b;
    hn::Mask<DU> halves;
};

HWY_INLINE VU mix_channel(VU a, VU b, const ColorWeights& weights, int lsb) {
    const VU sum =
        hn::Add(hn::Mul(channel(a, lsb), weights.a), hn::Mul(channel(b, lsb), weights.b));
    const VU mixed = hn::IfThenElse(weights.halves, hn::ShiftRight<1>(sum), third(sum));
    return hn::ShiftLeftSame(mixed, lsb);
}

HWY_INLINE VU gather_at(const TextureUnit& unit, VI offset) {
    return hn::GatherOffset(DU(), reinterpret_cast<const std::uint32_t*>(unit.texels), offset);
}

HWY_INLINE VU decode_block_color(const TextureUnit& unit, VI block, VU texel) {
    const DU d;
    const bool dxt1 = unit.format == Format::Dxt1Rgb || unit.format == Format::Dxt1Rgba;
    const VU ends = gather_at(unit, block);
    const VU codes = gather_at(unit, hn::Add(block, constant(4)));
    const VU code = hn::And(hn::Shr(codes, hn::Add(texel, texel)), hn::Set(d, 3));
    const VU c0 = hn::And(ends, hn::Set(d, 0xffff)), c1 = hn::ShiftRight<16>(ends);
    const VU a = expand_rgb565(c0), b = expand_rgb565(c1);

    const VU two = hn::Set(d, 2), three = hn::Set(d, 3);
    const auto ordered = hn::Not(hn::Gt(hn::BitCast(DI(), c0), hn::BitCast(DI(), c1)));
    const auto short_palette = dxt1 ? hn::RebindMask(d, ordered) : hn::Ne(texel, texel);
    // Code 2: 2 a + b, code 3: a + 2 b, over 3; with the short palette code 2: a + b, over 2.
    const auto is_two = hn::Eq(code, two);
    ColorWeights weights{hn::IfThenElse(is_two, two, hn::Set(d, 1)),
                         hn::IfThenElse(is_two, hn::Set(d, 1), two),
                         short_palette};
    weights.a = hn::IfThenElse(short_palette, hn::Set(d, 1), weights.a);
    weights.b = hn::IfThenElse(short_palette, hn::Set(d, 1), weights.b);
    const VU rg = hn::Or(mix_channel(a, b, weights, 0), mix_channel(a, b, weights, 8));
    VU mixed = hn::Or(hn::Or(rg, mix_channel(a, b, weights, 16)), hn::Set(d, 0xff000000u));

    const VU last = hn::Set(d, unit.format == Format::Dxt1Rgba ? 0 : 0xff000000u);
    mixed = hn::IfThenElse(hn::And(short_palette, hn::Eq(code, three)), last, mixed);
    const VU end = hn::IfThenElse(hn::Eq(code, hn::Zero(d)), a, b);
    return hn::IfThenElse(hn::TestBit(code, two), mixed, end);
}

HWY_INLINE VU decode_block_alpha3(const TextureUnit& unit, VI block, VU texel) {
    const DU d;
    const VU half = hn::ShiftLeft<2>(hn::ShiftRight<3>(texel));
    const VU word = gather_at(unit, hn::Add(block, hn::BitCast(DI(), half)));
    const VU shift = hn::ShiftLeft<2>(hn::And(texel, hn::Set(d, 7)));
    return hn::Mul(hn::And(hn::Shr(word, shift), hn::Set(d, 15)), hn::Set(d, 17));
}

// The 48 bits of codes begin at byte 2; a code's 3 bits lie within the 32 bits that begin at byte
// 2 (texels 0 .. 7) or byte 5 (texels 8 .. 15) of the block; that is 24 bits for 8 texels.
HWY_INLINE VU decode_block_alpha5(const TextureUnit& unit, VI block, VU texel) {
    const DU d;
    const VU ends = gather_at(unit, block);
    const VU a0 = hn::And(ends, hn::Set(d, 0xff));
    const VU a1 = hn::And(hn::ShiftRight<8>(ends), hn::Set(d, 0xff));
    const VU upper = hn::ShiftRight<3>(texel);
    const VU at = hn::Add(hn::Set(d, 2), hn::Add(upper, hn::Add(upper, upper)));
    const VU word = gather_at(unit, hn::Add(block, hn::BitCast(DI(), at)));
    const VU in_word = hn::And(texel, hn::Set(d, 7));
    const VU code =
        hn::And(hn::Shr(word, hn::Add(in_word, hn::Add(in_word, in_word))), hn::Set(d, 7));

    // Codes 2 .. 7 weigh a1 by code - 1. The results for codes 0 and 1 are replaced below.
    const VU weight1 = hn::Sub(code, hn::Set(d, 1));
    const VU by_seven = hn::Add(hn::Mul(hn::Sub(hn::Set(d, 8), code), a0), hn::Mul(weight1, a1));
    const VU by_five = hn::Add(hn::Mul(hn::Sub(hn::Set(d, 6), code), a0), hn::Mul(weight1, a1));
    const VU constants = hn::IfThenElseZero(hn::Eq(code, hn::Set(d, 7)), hn::Set(d, 255));
    const auto seven = hn::RebindMask(d, hn::Gt(hn::BitCast(DI(), a0), hn::BitCast(DI(), a1)));
    const auto is_constant = hn::Eq(hn::And(code, hn::Set(d, 6)), hn::Set(d, 6));
    const VU short_alpha = hn::IfThenElse(is_constant, constants, fifth(by_five));
    VU alpha = hn::IfThenElse(seven, seventh(by_seven), short_alpha);
    alpha = hn::IfThenElse(hn::Eq(code, hn::Set(d, 1)), a1, alpha);
    return hn::IfThenElse(hn::Eq(code, hn::Zero(d)), a0, alpha);
}

// `block`: byte offset from the texture's first; `texel`: 4 y + x within the block.
HWY_INLINE VU decode_s3tc(const TextureUnit& unit, VI block, VU texel) {
    if (unit.format == Format::Dxt1Rgb || unit.format == Format::Dxt1Rgba)
        return decode_block_color(unit, block, texel);
    const VU color = decode_block_color(unit, hn::Add(block, constant(8)), texel);
    const VU alpha = unit.format == Format::Dxt3 ? decode_block_alpha3(unit, block, texel)
                                                 : decode_block_alpha5(unit, block, texel);
    return hn::Or(hn::And(color, hn::Set(DU(), 0x00ffffffu)), hn::ShiftLeft<24>(alpha));
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
