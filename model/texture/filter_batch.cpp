// Vector form of the reference's filter: wrap, read and interpolate one level or two for each lane.
//
// Lanes may stand at different levels: sizes, strides and offsets are vectors then. Two vectors of
// fragments are done together, which makes one vector of each 16-bit output channel.

#include "model/texture/sampling_batch.h"
#include "model/texture/simd_targets.h"

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/texture/filter_batch.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "model/texture/axis-inl.h"
#include "model/texture/texels-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

#if HWY_TARGET == HWY_SCALAR
// One lane cannot hold two channels; sample() asks and takes the reference instead.
bool has_vectors() {
    return false;
}
void filter_texels(const TextureUnit&, const FilterInputs&, ColorPlanes&) {}
#else
bool has_vectors() {
    return true;
}

using D16 = hn::Repartition<std::uint16_t, DU>;
using V16 = hn::Vec<D16>;

// Channels as 16-bit lanes: r and b of a fragment in one vector, g and a in the other.
struct Color16 {
    V16 rb, ga;
};

HWY_INLINE Color16 split(VU rgba) {
    const VU mask = hn::Set(DU(), 0x00ff00ffu);
    return {hn::BitCast(D16(), hn::And(rgba, mask)),
            hn::BitCast(D16(), hn::And(hn::ShiftRight<8>(rgba), mask))};
}

// 256 a + (b - a) w + 128 is below 2^16 though its parts wrap around.
HWY_INLINE V16 lerp8w(V16 a, V16 b, V16 weight) {
    const V16 offset = hn::Mul(hn::Sub(b, a), weight);
    const V16 rounded = hn::Add(hn::ShiftLeft<8>(a), hn::Set(D16(), 128));
    return hn::ShiftRight<8>(hn::Add(rounded, offset));
}

HWY_INLINE Color16 lerp8w(const Color16& a, const Color16& b, VI weight) {
    const V16 w = hn::BitCast(D16(), weight);
    return {lerp8w(a.rb, b.rb, w), lerp8w(a.ga, b.ga, w)};
}

HWY_INLINE Color16 select(MI mask, const Color16& yes, const Color16& no) {
    const auto m = hn::VecFromMask(DI(), mask);
    const auto wide = hn::MaskFromVec(hn::BitCast(D16(), m));
    return {hn::IfThenElse(wide, yes.rb, no.rb), hn::IfThenElse(wide, yes.ga, no.ga)};
}

// What the lanes' levels are made of.
struct LevelVectors {
    AxisLevel axes[3];
    VI offset, row_stride, layer_stride;
};

HWY_INLINE VI look_up(const std::array<std::uint32_t, LevelTable::Size>& table, VI level) {
    return hn::BitCast(DI(), hn::GatherIndex(DU(), table.data(), level));
}

HWY_INLINE LevelVectors level_vectors(const TextureUnit& unit, VI level) {
    LevelVectors result;
    for (unsigned axis = 0; axis < 3; ++axis)
        result.axes[axis] = axis_level(unit, axis, level);
    result.offset = look_up(unit.levels.offset, level);
    result.row_stride = look_up(unit.levels.row_stride, level);
    result.layer_stride = look_up(unit.levels.layer_stride, level);
    return result;
}

// One vector of fragments.
struct FragmentVector {
    VF folded[3];
    VI face;      // of cube maps
    VI reference; // of depth textures
};

// Two texels along an axis, ready to address.
struct TexelPair {
    StoredIndex first, second;
    VI weight;
};

// Without a border, stored or coloured, every index lies inside.
template <bool Border>
HWY_INLINE StoredIndex address_index(const TextureUnit& unit, VI index, VI size) {
    if constexpr (Border) return stored_index(unit, index, size);
    return {index, no_lanes()};
}

template <bool Border, bool Linear>
HWY_INLINE TexelPair texel_pair(const TextureUnit& unit,
                                unsigned axis,
                                const FragmentVector& fragments,
                                const LevelVectors& level) {
    const AxisLevel& at = level.axes[axis];
    const AxisTexelVectors texels = axis_texels<Linear>(unit, axis, fragments.folded[axis], at);
    return {address_index<Border>(unit, texels.first, at.size),
            address_index<Border>(unit, texels.second, at.size),
            texels.weight};
}

// What one 2x2 filter in one layer needs besides the texels' columns.
struct Layer {
    VI offset; // bytes from the texture's first
    MI outside;
};

template <class Texels, bool Border>
HWY_INLINE Color16 read_color(const TextureUnit& unit,
                              const FragmentVector& fragments,
                              VI row,
                              const StoredIndex& x,
                              const StoredIndex& y,
                              MI layer_outside) {
    VU rgba = Texels::read(unit, row, x.index, y.index, fragments.reference);
    if constexpr (Border) {
        const MI outside = hn::Or(layer_outside, hn::Or(x.outside, y.outside));
        rgba = hn::IfThenElse(
            hn::RebindMask(DU(), outside), border_texel(unit, fragments.reference), rgba);
    }
    return split(rgba);
}

template <class Texels, bool Border, bool Linear>
HWY_INLINE Color16 filter_layer(const TextureUnit& unit,
                                const FragmentVector& fragments,
                                const LevelVectors& level,
                                const TexelPair& x,
                                const TexelPair& y,
                                const Layer& layer) {
    const auto row = [&](const StoredIndex& at) HWY_ATTR {
        const VI first = hn::Add(layer.offset, hn::Mul(Texels::row_of(at.index), level.row_stride));
        const Color16 left =
            read_color<Texels, Border>(unit, fragments, first, x.first, at, layer.outside);
        if constexpr (!Linear) return left;
        const Color16 right =
            read_color<Texels, Border>(unit, fragments, first, x.second, at, layer.outside);
        return lerp8w(left, right, x.weight);
    };
    const Color16 lower = row(y.first);
    if constexpr (!Linear) return lower;
    return lerp8w(lower, row(y.second), y.weight);
}

HWY_INLINE Layer layer_at(const LevelVectors& level, const StoredIndex& z) {
    return {hn::Add(level.offset, hn::Mul(z.index, level.layer_stride)), z.outside};
}

// A 1-D image is filtered as a 2-D one whose two rows are the same: a lerp of equals changes
// nothing.
template <class Texels, bool Border, bool Linear>
HWY_INLINE Color16 filter_level(const TextureUnit& unit,
                                const FragmentVector& fragments,
                                const LevelVectors& level) {
    const MI nowhere = no_lanes();
    const StoredIndex zero{hn::Zero(DI()), nowhere};
    const TexelPair x = texel_pair<Border, Linear>(unit, 0, fragments, level);
    TexelPair y{zero, zero, zero.index};
    if (unit.dimensions > 1) y = texel_pair<Border, Linear>(unit, 1, fragments, level);

    if (unit.dimensions < 3) {
        const bool cube = unit.kind == TextureKind::Cube;
        const Layer layer =
            cube ? layer_at(level, {fragments.face, nowhere}) : Layer{level.offset, nowhere};
        return filter_layer<Texels, Border, Linear>(unit, fragments, level, x, y, layer);
    }
    const TexelPair z = texel_pair<Border, Linear>(unit, 2, fragments, level);
    const Color16 first = filter_layer<Texels, Border, Linear>(
        unit, fragments, level, x, y, layer_at(level, z.first));
    if constexpr (!Linear) return first;
    const Color16 second = filter_layer<Texels, Border, Linear>(
        unit, fragments, level, x, y, layer_at(level, z.second));
    return lerp8w(first, second, z.weight);
}

// A batch's choice of levels, and their constants where one level serves all lanes, else null.
struct BatchFilter {
    const SamplingBatch& sampling;
    const LevelVectors* level;
    const LevelVectors* next_level;
};

template <class Texels, bool Border>
HWY_INLINE Color16 filter_level(const TextureUnit& unit,
                                const FragmentVector& fragments,
                                const LevelVectors& level,
                                const BatchFilter& filter,
                                VI choice) {
    if (!filter.sampling.any_nearest())
        return filter_level<Texels, Border, true>(unit, fragments, level);
    const Color16 nearest = filter_level<Texels, Border, false>(unit, fragments, level);
    if (!filter.sampling.any_linear()) return nearest;
    const Color16 linear = filter_level<Texels, Border, true>(unit, fragments, level);
    const MI is_linear = hn::TestBit(choice, constant(SamplingBatch::LinearBit));
    return select(is_linear, linear, nearest);
}

HWY_INLINE FragmentVector load_fragments(const TextureUnit& unit,
                                         const FilterInputs& in,
                                         unsigned lane) {
    const DF d;
    const float* planes[3] = {
        in.coordinates->s.data(), in.coordinates->t.data(), in.coordinates->r.data()};
    FragmentVector result;
    for (unsigned axis = 0; axis < 3; ++axis) {
        result.folded[axis] = hn::Zero(d);
        if (axis >= unit.dimensions) continue;
        const VF coordinate = hn::Load(d, planes[axis] + lane);
        result.folded[axis] =
            fold_coordinate(unit.linear_rules[axis].fold, coordinate, unit.extent[axis]);
    }
    const bool cube = unit.kind == TextureKind::Cube;
    result.face = cube ? hn::Load(DI(), in.face + lane) : hn::Zero(DI());
    result.reference = hn::Zero(DI());
    if (unit.compares()) result.reference = reference_depth(hn::Load(d, in.reference + lane));
    return result;
}

// The constants of the lanes' levels: the batch's, or made for these lanes in `own`.
HWY_INLINE const LevelVectors&
vectors_at(const TextureUnit& unit, const LevelVectors* of_batch, VI level, LevelVectors& own) {
    if (of_batch) return *of_batch;
    own = level_vectors(unit, level);
    return own;
}

// The colours of one vector of fragments, from one level or two.
template <class Texels, bool Border>
HWY_INLINE Color16 filter_fragments(const TextureUnit& unit,
                                    const FilterInputs& in,
                                    const BatchFilter& filter,
                                    unsigned lane) {
    const FragmentVector fragments = load_fragments(unit, in, lane);
    const VI choice = hn::BitCast(DI(), hn::Load(DU(), in.sampling->choice.data() + lane));
    const VI byte = constant(0xff);
    const VI at = hn::And(choice, byte);
    LevelVectors own;
    const Color16 fine = filter_level<Texels, Border>(
        unit, fragments, vectors_at(unit, filter.level, at, own), filter, choice);
    if (!in.sampling->any_weight()) return fine;

    const VI weight = hn::And(hn::ShiftRight<16>(choice), byte);
    if (hn::AllTrue(DI(), hn::Eq(weight, hn::Zero(DI())))) return fine;
    const VI next = hn::And(hn::ShiftRight<8>(choice), byte);
    const Color16 coarse = filter_level<Texels, Border>(
        unit, fragments, vectors_at(unit, filter.next_level, next, own), filter, choice);
    return lerp8w(fine, coarse, hn::Or(weight, hn::ShiftLeft<16>(weight)));
}

template <class Texels, bool Border>
void filter_all(const TextureUnit& unit, const FilterInputs& in, ColorPlanes& out) {
    const D16 d16;
    const auto step = static_cast<unsigned>(hn::Lanes(DI()));
    const SamplingBatch& sampling = *in.sampling;
    const auto first = static_cast<std::int32_t>(sampling.all_of);
    const LevelVectors level = level_vectors(unit, constant(first & 0xff));
    const LevelVectors next_level = level_vectors(unit, constant(first >> 8 & 0xff));
    const BatchFilter filter{sampling,
                             sampling.one_level() ? &level : nullptr,
                             sampling.one_next_level() ? &next_level : nullptr};
    for (unsigned lane = 0; lane < 4 * grouped_quads(in.quad_count); lane += 2 * step) {
        const Color16 lower = filter_fragments<Texels, Border>(unit, in, filter, lane);
        const Color16 upper = filter_fragments<Texels, Border>(unit, in, filter, lane + step);
        hn::Store(hn::ConcatEven(d16, upper.rb, lower.rb), d16, out.r.data() + lane);
        hn::Store(hn::ConcatEven(d16, upper.ga, lower.ga), d16, out.g.data() + lane);
        hn::Store(hn::ConcatOdd(d16, upper.rb, lower.rb), d16, out.b.data() + lane);
        hn::Store(hn::ConcatOdd(d16, upper.ga, lower.ga), d16, out.a.data() + lane);
    }
}

void filter_texels(const TextureUnit& unit, const FilterInputs& in, ColorPlanes& out) {
    const FormatInfo& info = format_info(unit.format);
    const bool border = unit.border != 0 || unit.border_color;
    if (info.is_depth) return filter_all<DepthTexels, true>(unit, in, out);
    if (info.block_width > 1) return filter_all<BlockTexels, true>(unit, in, out);
    if (info.block_bytes == 4)
        return border ? filter_all<WordTexels, true>(unit, in, out)
                      : filter_all<WordTexels, false>(unit, in, out);
    return border ? filter_all<SmallTexels, true>(unit, in, out)
                  : filter_all<SmallTexels, false>(unit, in, out);
}

#endif // HWY_SCALAR

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {
namespace {
HWY_EXPORT(has_vectors);
HWY_EXPORT(filter_texels);
} // namespace

bool can_filter_batches() {
    return HWY_DYNAMIC_DISPATCH(has_vectors)();
}

void filter_batch(const TextureUnit& unit, const FilterInputs& inputs, ColorPlanes& out) {
    HWY_DYNAMIC_DISPATCH(filter_texels)(unit, inputs, out);
}

} // namespace ffgpu
#endif
