// Vector form of texel_read.h: gathers texels and decodes them to packed r g b a, 8 bits each, red
// in the lowest byte. Included once for each instruction set.

#if defined(FFGPU_MODEL_TEXTURE_TEXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_TEXTURE_TEXELS_INL_H
#undef FFGPU_MODEL_TEXTURE_TEXELS_INL_H
#else
#define FFGPU_MODEL_TEXTURE_TEXELS_INL_H
#endif

#include "model/arith/fxt1.h"
#include "model/arith/srgb.h"
#include "model/texture/axis-inl.h"
#include "model/texture/filter.h"
#include "model/texture/s3tc-inl.h"
#include "model/texture/texture_unit.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

HWY_INLINE VU bits(VU value, unsigned lsb, std::uint32_t mask) {
    return hn::And(hn::ShiftRightSame(value, static_cast<int>(lsb)), hn::Set(DU(), mask));
}

HWY_INLINE VU pack_rgba(VU r, VU g, VU b, VU a) {
    const VU low = hn::Or(r, hn::ShiftLeft<8>(g));
    const VU high = hn::Or(hn::ShiftLeft<16>(b), hn::ShiftLeft<24>(a));
    return hn::Or(low, high);
}

HWY_INLINE VU opaque() {
    return hn::Set(DU(), 255);
}

// decode_color_texel() for the formats of one or two bytes.
HWY_INLINE VU decode_small(Format format, VU raw) {
    const DU d;
    const VU first = bits(raw, 0, 0xff);
    switch (format) {
    case Format::Luminance8:
        return pack_rgba(first, first, first, opaque());
    case Format::Alpha8:
        return hn::ShiftLeft<24>(raw);
    case Format::Intensity8:
        return pack_rgba(first, first, first, first);
    case Format::LuminanceAlpha8:
        return pack_rgba(first, first, first, bits(raw, 8, 0xff));
    case Format::Rgb565:
        return expand_rgb565(raw);
    case Format::Rgba4: {
        const VU swapped =
            pack_rgba(bits(raw, 12, 15), bits(raw, 8, 15), bits(raw, 4, 15), bits(raw, 0, 15));
        return hn::Or(swapped, hn::ShiftLeft<4>(swapped));
    }
    case Format::Rgb5a1: {
        const VU a = hn::IfThenElseZero(hn::TestBit(raw, hn::Set(d, 1)), opaque());
        return pack_rgba(
            widen5(bits(raw, 11, 31)), widen5(bits(raw, 6, 31)), widen5(bits(raw, 1, 31)), a);
    }
    default:
        return hn::Set(d, 0xff000000u);
    }
}

HWY_INLINE MI compare_passes(Compare compare, VI reference, VI depth) {
    const VI zero = hn::Zero(DI());
    switch (compare) {
    case Compare::Less:
        return hn::Lt(reference, depth);
    case Compare::Equal:
        return hn::Eq(reference, depth);
    case Compare::Lequal:
        return hn::Not(hn::Gt(reference, depth));
    case Compare::Greater:
        return hn::Gt(reference, depth);
    case Compare::Notequal:
        return hn::Ne(reference, depth);
    case Compare::Gequal:
        return hn::Not(hn::Lt(reference, depth));
    case Compare::Always:
        return hn::Eq(zero, zero);
    default:
        return no_lanes();
    }
}

// depth_color() of 24-bit depths.
HWY_INLINE VU depth_color(const Sampler& sampler, VI reference, VU depth) {
    VU value = hn::ShiftRight<16>(depth);
    if (sampler.compare_enable) {
        const MI passes = compare_passes(sampler.compare, reference, hn::BitCast(DI(), depth));
        value = hn::BitCast(DU(), hn::IfThenElseZero(passes, constant(255)));
    }
    if (sampler.depth_mode == DepthMode::Intensity) return pack_rgba(value, value, value, value);
    if (sampler.depth_mode == DepthMode::Alpha) return hn::ShiftLeft<24>(value);
    return pack_rgba(value, value, value, opaque());
}

HWY_INLINE VU decode_depth(const TextureUnit& unit, VI reference, VU raw) {
    const VU narrow = bits(raw, 0, 0xffff);
    const VU depth = unit.format == Format::Depth24Stencil8
                         ? hn::ShiftRight<8>(raw)
                         : hn::Or(hn::ShiftLeft<8>(narrow), hn::ShiftRight<8>(narrow));
    return depth_color(unit.sampler, reference, depth);
}

// What depths are compared with.
HWY_INLINE VI reference_depth(VF r) {
    const DF d;
    const VF clamped = hn::Min(hn::Max(r, hn::Zero(d)), hn::Set(d, 1.0f));
    return hn::NearestInt(hn::Mul(clamped, hn::Set(d, 16777215.0f)));
}

// The border colour as a texel.
HWY_INLINE VU border_texel(const TextureUnit& unit, VI reference) {
    const Sampler& sampler = unit.sampler;
    if (!format_info(unit.format).is_depth) return hn::Set(DU(), sampler.border_color);
    return depth_color(sampler, reference, hn::Set(DU(), sampler.border_depth & 0xffffff));
}

// A texel kind knows how texels lie in a row and what they mean:
//   row_of(y)                  the row (of blocks) that holds y
//   read(unit, row, x, y, ref) the texels x of the rows at byte offset `row`
// and those whose neighbours one load reads together (texel_places-inl.h):
//   Pair                       the unsigned lane that holds two neighbours, and maybe more
//   bytes(unit)                of a texel
//   decode(unit, raw)          what texels in the lowest bits of words mean

// Rgba8, the fast case.
struct WordTexels {
    using Pair = std::uint64_t;
    static HWY_INLINE VI row_of(VI y) { return y; }
    static HWY_INLINE int bytes(const TextureUnit&) { return 4; }
    static HWY_INLINE VU decode(const TextureUnit&, VU raw) { return raw; }
    static HWY_INLINE VU read(const TextureUnit& unit, VI row, VI x, VI, VI) {
        return gather_at(unit, hn::Add(row, hn::ShiftLeft<2>(x)));
    }
};

// Rgbx8.
struct OpaqueWordTexels {
    using Pair = std::uint64_t;
    static HWY_INLINE VI row_of(VI y) { return y; }
    static HWY_INLINE int bytes(const TextureUnit&) { return 4; }
    static HWY_INLINE VU decode(const TextureUnit&, VU raw) {
        return hn::Or(raw, hn::Set(DU(), 0xff000000u));
    }
    static HWY_INLINE VU read(const TextureUnit& unit, VI row, VI x, VI y, VI reference) {
        return decode(unit, WordTexels::read(unit, row, x, y, reference));
    }
};

// Colour formats of one and two bytes.
struct SmallTexels {
    using Pair = std::uint32_t;
    static HWY_INLINE VI row_of(VI y) { return y; }
    static HWY_INLINE int bytes(const TextureUnit& unit) {
        return format_info(unit.format).block_bytes;
    }
    static HWY_INLINE VU decode(const TextureUnit& unit, VU raw) {
        return decode_small(unit.format, raw);
    }
    static HWY_INLINE VU read(const TextureUnit& unit, VI row, VI x, VI, VI) {
        const int shift = bytes(unit) == 2 ? 1 : 0;
        return decode(unit, gather_at(unit, hn::Add(row, hn::ShiftLeftSame(x, shift))));
    }
};

// Blocks of 4x4.
struct BlockTexels {
    static HWY_INLINE VI row_of(VI y) { return hn::ShiftRight<2>(y); }
    static HWY_NOINLINE VU read(const TextureUnit& unit, VI row, VI x, VI y, VI) {
        const int shift = format_info(unit.format).block_bytes == 16 ? 4 : 3;
        const VI block = hn::Add(row, hn::ShiftLeftSame(hn::ShiftRight<2>(x), shift));
        const VI three = constant(3);
        const VI texel = hn::Or(hn::ShiftLeft<2>(hn::And(y, three)), hn::And(x, three));
        return decode_s3tc(unit, block, hn::BitCast(DU(), texel));
    }
};

// FXT1 blocks of 8x4: rare, and of too many codings for vectors. The scalar decoder, lane by lane.
struct Fxt1Texels {
    static HWY_INLINE VI row_of(VI y) { return hn::ShiftRight<2>(y); }
    static HWY_NOINLINE VU read(const TextureUnit& unit, VI row, VI x, VI y, VI) {
        constexpr std::size_t Lanes = hn::MaxLanes(DU());
        alignas(64) std::int32_t block[Lanes], column[Lanes], line[Lanes];
        alignas(64) std::uint32_t rgba[Lanes];
        hn::Store(hn::Add(row, hn::ShiftLeft<4>(hn::ShiftRight<3>(x))), DI(), block);
        hn::Store(hn::And(x, constant(7)), DI(), column);
        hn::Store(hn::And(y, constant(3)), DI(), line);
        for (std::size_t i = 0; i < Lanes; ++i) {
            const Rgba color = decode_fxt1(unit.texels + block[i],
                                           static_cast<unsigned>(column[i]),
                                           static_cast<unsigned>(line[i]),
                                           unit.format == Format::Fxt1Rgba);
            rgba[i] = color[0] | std::uint32_t{color[1]} << 8 | std::uint32_t{color[2]} << 16 |
                      std::uint32_t{color[3]} << 24;
        }
        return hn::Load(DU(), rgba);
    }
};

// linear_from_srgb(): the table is read at byte offsets.
HWY_INLINE VU linear_channel(VU color, int lsb) {
    const VU code = channel(color, lsb);
    const auto* table = reinterpret_cast<const std::uint32_t*>(SrgbToLinear8.data());
    const VU linear = hn::GatherOffset(DU(), table, hn::BitCast(DI(), code));
    return hn::ShiftLeftSame(hn::And(linear, hn::Set(DU(), 0xff)), lsb);
}

HWY_INLINE VU linear_from_srgb(VU color) {
    const VU alpha = hn::And(color, hn::Set(DU(), 0xff000000u));
    const VU rg = hn::Or(linear_channel(color, 0), linear_channel(color, 8));
    return hn::Or(hn::Or(rg, linear_channel(color, 16)), alpha);
}

// Any of the kinds above with sRGB codes for r, g and b.
template <class Encoded>
struct SrgbTexels {
    static HWY_INLINE VI row_of(VI y) { return Encoded::row_of(y); }
    static HWY_INLINE VU read(const TextureUnit& unit, VI row, VI x, VI y, VI reference) {
        return linear_from_srgb(Encoded::read(unit, row, x, y, reference));
    }
};

// Depths.
struct DepthTexels {
    static HWY_INLINE VI row_of(VI y) { return y; }
    static HWY_INLINE VU read(const TextureUnit& unit, VI row, VI x, VI, VI reference) {
        const int shift = unit.format == Format::Depth24Stencil8 ? 2 : 1;
        const VU raw = gather_at(unit, hn::Add(row, hn::ShiftLeftSame(x, shift)));
        return decode_depth(unit, reference, raw);
    }
};

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
