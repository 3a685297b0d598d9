// Vector form of the reference's filter_level(): wraps, reads and interpolates the texels of one
// level for each lane. Lanes may stand at different levels: sizes, strides and offsets are vectors.
// Included once for each instruction set.

#if defined(FFGPU_MODEL_TEXTURE_LEVEL_FILTER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_TEXTURE_LEVEL_FILTER_INL_H
#undef FFGPU_MODEL_TEXTURE_LEVEL_FILTER_INL_H
#else
#define FFGPU_MODEL_TEXTURE_LEVEL_FILTER_INL_H
#endif

#include "model/texture/axis-inl.h"
#include "model/texture/sampling_batch.h"
#include "model/texture/texels-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

using D16 = hn::Repartition<std::uint16_t, DU>;
using V16 = hn::Vec<D16>;

// Channels as 16-bit lanes: r and b of a fragment in one vector, g and a in the other.
struct Color16 {
    V16 rb, ga;
};

using D16Signed = hn::RebindToSigned<D16>;

HWY_INLINE Color16 split(VU rgba) {
    const VU mask = hn::Set(DU(), 0x00ff00ffu);
    return {hn::BitCast(D16(), hn::And(rgba, mask)),
            hn::BitCast(D16(), hn::And(hn::ShiftRight<8>(rgba), mask))};
}

// (256 a + (b - a) w + 128) >> 8 is a more than the rounded high half of (b - a) times 128 w,
// twice.
HWY_INLINE V16 lerp8w(V16 a, V16 b, hn::Vec<D16Signed> weight128) {
    const D16Signed d;
    const auto difference = hn::Sub(hn::BitCast(d, b), hn::BitCast(d, a));
    return hn::Add(a, hn::BitCast(D16(), hn::MulFixedPoint15(difference, weight128)));
}

// `weight`: 128 times it, in both halves of its lane.
HWY_INLINE Color16 lerp8w(const Color16& a, const Color16& b, VI weight) {
    const auto w = hn::BitCast(D16Signed(), weight);
    return {lerp8w(a.rb, b.rb, w), lerp8w(a.ga, b.ga, w)};
}

// What a pass over a batch is specialised for. Plain: a 2-D image, so no third axis and no faces.
// Border: border texels, stored or coloured, can be met.
template <class TexelKind, bool IsPlain, bool HasBorder>
struct Kernel {
    using Texels = TexelKind;
    static constexpr bool Plain = IsPlain;
    static constexpr bool Border = HasBorder;
};

// The lanes' levels.
struct LevelVectors {
    AxisLevel x, y, z;
    VI offset, row_stride, layer_stride;
};

HWY_INLINE VI look_up(const std::array<std::uint32_t, LevelTable::Size>& table, VI level) {
    return hn::BitCast(DI(), hn::GatherIndex(DU(), table.data(), level));
}

template <class K>
HWY_INLINE void set_level(const TextureUnit& unit, VI level, LevelVectors& out) {
    out.x = axis_level(unit, 0, level);
    out.y = axis_level(unit, 1, level);
    out.offset = look_up(unit.levels.offset, level);
    out.row_stride = look_up(unit.levels.row_stride, level);
    if constexpr (K::Plain) return;
    out.z = axis_level(unit, 2, level);
    out.layer_stride = look_up(unit.levels.layer_stride, level);
}

// Two texels along an axis, ready to address.
struct TexelPair {
    StoredIndex first, second;
    VI weight;
};

template <class K>
HWY_INLINE StoredIndex address_index(const TextureUnit& unit, VI index, VI size) {
    if constexpr (K::Border) return stored_index(unit, index, size);
    return {index, no_lanes()};
}

template <class K, bool Linear>
HWY_INLINE TexelPair texel_pair(const TextureUnit& unit,
                                unsigned axis,
                                const float* coordinates,
                                const AxisLevel& level) {
    const VF coordinate = hn::Load(DF(), coordinates);
    const VF folded = fold_coordinate(unit.linear_rules[axis].fold, coordinate, unit.extent[axis]);
    const AxisTexelVectors texels = axis_texels<Linear>(unit, axis, folded, level);
    return {address_index<K>(unit, texels.first, level.size),
            address_index<K>(unit, texels.second, level.size),
            texels.weight};
}

// One layer of the image, and the comparison's other side.
struct LayerVectors {
    VI offset; // bytes from the texture's first
    MI outside;
    VI reference;
};

template <class K>
HWY_INLINE Color16 read_color(const TextureUnit& unit,
                              const LayerVectors& layer,
                              VI row,
                              const StoredIndex& x,
                              const StoredIndex& y) {
    const VU rgba = K::Texels::read(unit, row, x.index, y.index, layer.reference);
    if constexpr (!K::Border) return split(rgba);
    const MI outside = hn::Or(layer.outside, hn::Or(x.outside, y.outside));
    const VU border = border_texel(unit, layer.reference);
    return split(hn::IfThenElse(hn::RebindMask(DU(), outside), border, rgba));
}

template <class K, bool Linear>
HWY_INLINE Color16 filter_row(const TextureUnit& unit,
                              const LevelVectors& level,
                              const LayerVectors& layer,
                              const TexelPair& x,
                              const StoredIndex& y) {
    const VI in_layer = hn::Mul(K::Texels::row_of(y.index), level.row_stride);
    const VI row = hn::Add(layer.offset, in_layer);
    const Color16 left = read_color<K>(unit, layer, row, x.first, y);
    if constexpr (!Linear) return left;
    return lerp8w(left, read_color<K>(unit, layer, row, x.second, y), x.weight);
}

template <class K, bool Linear>
HWY_INLINE Color16 filter_layer(const TextureUnit& unit,
                                const LevelVectors& level,
                                const LayerVectors& layer,
                                const TexelPair& x,
                                const TexelPair& y) {
    const Color16 first = filter_row<K, Linear>(unit, level, layer, x, y.first);
    if constexpr (!Linear) return first;
    return lerp8w(first, filter_row<K, Linear>(unit, level, layer, x, y.second), y.weight);
}

HWY_INLINE LayerVectors layer_at(const LevelVectors& level, const StoredIndex& z, VI reference) {
    return {hn::Add(level.offset, hn::Mul(z.index, level.layer_stride)), z.outside, reference};
}

// Any kind of texture. A 1-D image counts as a 2-D one whose two rows are the same: to interpolate
// between equals changes nothing.
template <class K, bool Linear>
HWY_INLINE Color16 filter_any(const TextureUnit& unit,
                              const FilterInputs& in,
                              const LevelVectors& level,
                              unsigned lane) {
    const StoredIndex none{hn::Zero(DI()), no_lanes()};
    VI reference = none.index;
    if (unit.compares()) reference = reference_depth(hn::Load(DF(), in.reference + lane));
    const TexelPair x = texel_pair<K, Linear>(unit, 0, in.coordinates->s.data() + lane, level.x);
    if (unit.dimensions == 1) {
        const LayerVectors layer = layer_at(level, none, reference);
        return filter_row<K, Linear>(unit, level, layer, x, none);
    }
    const TexelPair y = texel_pair<K, Linear>(unit, 1, in.coordinates->t.data() + lane, level.y);
    if (unit.dimensions == 2) {
        StoredIndex face = none;
        if (unit.kind == TextureKind::Cube) face.index = hn::Load(DI(), in.face + lane);
        return filter_layer<K, Linear>(unit, level, layer_at(level, face, reference), x, y);
    }
    const TexelPair z = texel_pair<K, Linear>(unit, 2, in.coordinates->r.data() + lane, level.z);
    const Color16 first =
        filter_layer<K, Linear>(unit, level, layer_at(level, z.first, reference), x, y);
    if constexpr (!Linear) return first;
    const Color16 second =
        filter_layer<K, Linear>(unit, level, layer_at(level, z.second, reference), x, y);
    return lerp8w(first, second, z.weight);
}

template <class K, bool Linear>
HWY_INLINE Color16 filter_level(const TextureUnit& unit,
                                const FilterInputs& in,
                                const LevelVectors& level,
                                unsigned lane) {
    if constexpr (!K::Plain) return filter_any<K, Linear>(unit, in, level, lane);
    const TexelPair x = texel_pair<K, Linear>(unit, 0, in.coordinates->s.data() + lane, level.x);
    const TexelPair y = texel_pair<K, Linear>(unit, 1, in.coordinates->t.data() + lane, level.y);
    const LayerVectors layer{level.offset, no_lanes(), hn::Zero(DI())};
    return filter_layer<K, Linear>(unit, level, layer, x, y);
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
