// put_accesses() by vectors: the four lanes of a quad at once, where their accesses are regular.

#include "model/base/simd_targets.h"
#include "model/work/access_columns.h"

#include <array>
#include <cstddef>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/work/access_columns_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::work::HWY_NAMESPACE {
namespace {

#if HWY_TARGET != HWY_SCALAR // Vectors of one lane hold no quad.

namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::FixedTag<std::uint32_t, 4>;
using D16 = hn::FixedTag<std::uint16_t, 8>;
using Words = hn::Vec<D32>;

// Of each half on its own.
HWY_INLINE Words difference(Words a, Words b) {
    return hn::BitCast(D32(), hn::Sub(hn::BitCast(D16(), a), hn::BitCast(D16(), b)));
}
HWY_INLINE Words zigzag_halves(Words steps) {
    const hn::RebindToSigned<D16> d;
    const auto value = hn::BitCast(d, steps);
    return hn::BitCast(D32(), hn::Xor(hn::ShiftLeft<1>(value), hn::ShiftRight<15>(value)));
}
// What lanes refer to: the first to `first`, the others to lane 0 of `words`.
HWY_INLINE Words references(std::uint32_t first, Words words) {
    return hn::InsertLane(hn::Broadcast<0>(words), 0, first);
}

// Of the first texels of the four lanes: their steps, zigzag.
HWY_INLINE Words tell_steps(Words places, AccessForecast::Past& past) {
    const D32 d;
    const Words from_reference = difference(places, references(past.place, places));
    const Words steps = zigzag_halves(difference(from_reference, hn::Load(d, past.steps.data())));
    hn::Store(from_reference, d, past.steps.data());
    past.place = hn::GetLane(places);
    return steps;
}

// Whether both steps of each are a byte.
HWY_INLINE bool are_short(Words steps) {
    const D32 d;
    return hn::AllTrue(d, hn::Eq(hn::And(steps, hn::Set(d, 0xff80ff80)), hn::Zero(d)));
}

// Appends words that are bytes, a byte each.
HWY_INLINE void put_bytes(std::uint8_t*& to, Words words) {
    const hn::FixedTag<std::uint8_t, 4> bytes;
    hn::StoreU(hn::DemoteTo(bytes, hn::BitCast(hn::RebindToSigned<D32>(), words)), bytes, to);
    to += 4;
}
// Those of lane 0 of one, of lane 0 of the other, of lane 1 of one ...
HWY_INLINE void put_bytes_in_turn(std::uint8_t*& to, Words one, Words other) {
    const D32 d;
    put_bytes(to, hn::InterleaveLower(d, one, other));
    put_bytes(to, hn::InterleaveUpper(d, one, other));
}

// Lane after lane, of each one step of every array.
template <std::size_t Each>
HWY_INLINE void put_long_steps(const std::array<Words, Each>& steps, AccessCursors& to) {
    alignas(16) std::array<std::array<std::uint32_t, 4>, Each> words;
    for (std::size_t i = 0; i < Each; ++i)
        hn::Store(steps[i], D32(), words[i].data());
    for (unsigned lane = 0; lane < 4; ++lane)
        for (const std::array<std::uint32_t, 4>& of : words) {
            to.x = put_number(to.x, of[lane] & 0xffff);
            to.y = put_number(to.y, of[lane] >> 16);
        }
}

// Only the level or layer of lane 0 may not be foreseen: those of the others are expected to be the
// same. Returns the shapes of all lanes.
HWY_INLINE Words tell_kind(const RegularAccesses& common,
                           std::uint8_t level,
                           TexelAccesses::Place place,
                           AccessForecast::Past& past,
                           AccessCursors& to) {
    const D32 d;
    const std::uint32_t shape = static_cast<std::uint32_t>(common.linear) << 2 | ShapeForeseen;
    const Words shapes = hn::Add(hn::Iota(d, 0), hn::Set(d, shape));
    const std::uint32_t kind = AccessForecast::kind(common.layer, level);
    if (past.kind == kind) return shapes;
    const auto expected_layer = static_cast<std::uint16_t>(std::exchange(past.kind, kind));
    to.rare = put_rare(to.rare, common.access(0, level, place), expected_layer);
    return hn::InsertLane(shapes, 0, shape - ShapeForeseen);
}

HWY_INLINE void put_level(const RegularAccesses& common,
                          const TexelAccesses::Place* places,
                          AccessForecast& forecast,
                          unsigned unit,
                          AccessCursors& to) {
    const D32 d;
    AccessForecast::Past& past = forecast.past(unit, 0);
    put_bytes(to.shape, tell_kind(common, common.level, places[0], past, to));
    const Words steps = tell_steps(hn::LoadU(d, places), past);
    if (!are_short(steps)) return put_long_steps<1>({steps}, to);
    put_bytes(to.x, hn::And(steps, hn::Set(d, 0xff)));
    put_bytes(to.y, hn::ShiftRight<16>(steps));
}

HWY_INLINE void put_two_levels(const RegularAccesses& common,
                               const TexelAccesses::Place* places,
                               AccessForecast& forecast,
                               unsigned unit,
                               AccessCursors& to) {
    const D32 d;
    AccessForecast::Past &past = forecast.past(unit, 0), &next_past = forecast.past(unit, 1);
    const auto next_level = static_cast<std::uint8_t>(common.level + 1);
    const Words shapes = tell_kind(common, common.level, places[0], past, to);
    const Words next_shapes = tell_kind(common, next_level, places[1], next_past, to);
    put_bytes_in_turn(to.shape, shapes, next_shapes);
    const Words low = hn::LoadU(d, places), high = hn::LoadU(d, places + 4);
    const Words steps = tell_steps(hn::ConcatEven(d, high, low), past);
    const Words next_steps = tell_steps(hn::ConcatOdd(d, high, low), next_past);
    if (!are_short(hn::Or(steps, next_steps))) return put_long_steps<2>({steps, next_steps}, to);
    const Words byte = hn::Set(d, 0xff);
    put_bytes_in_turn(to.x, hn::And(steps, byte), hn::And(next_steps, byte));
    put_bytes_in_turn(to.y, hn::ShiftRight<16>(steps), hn::ShiftRight<16>(next_steps));
}

#endif

HWY_INLINE void put_one_by_one(const TexelAccesses::OfQuad& quad,
                               unsigned unit,
                               AccessForecast& forecast,
                               AccessCursors& to) {
    forecast.begin_quad(unit);
    quad.for_each([&](const TexelAccess& access) { put_access(access, forecast, to); });
}

HWY_INLINE void put_quad(const TexelAccesses::OfQuad& quad,
                         unsigned unit,
                         AccessForecast& forecast,
                         AccessCursors& to) {
#if HWY_TARGET != HWY_SCALAR
    const RegularAccesses common = quad.common();
    if (quad.is_regular() && common.lanes == 0xf) {
        const TexelAccesses::Place* const places = quad.places().data();
        if (common.next_level)
            put_two_levels(common, places, forecast, unit, to);
        else
            put_level(common, places, forecast, unit, to);
        return;
    }
#endif
    put_one_by_one(quad, unit, forecast, to);
}

AccessCursors PutAccesses(const QuadAccesses& quads, AccessForecast& forecast, AccessCursors to) {
    std::size_t number = quads.first * quads.units.size();
    for (std::size_t i = 0; i < quads.count; ++i)
        for (const std::uint8_t unit : quads.units) {
            const TexelAccesses::OfQuad quad = quads.all.of(number++);
            to.number = put_number(to.number, quad.size());
            put_quad(quad, unit, forecast, to);
        }
    return to;
}

} // namespace
} // namespace ffgpu::work::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu::work {
namespace {
HWY_EXPORT(PutAccesses);
} // namespace

AccessCursors put_accesses(const QuadAccesses& quads, AccessForecast& forecast, AccessCursors to) {
    return HWY_DYNAMIC_DISPATCH(PutAccesses)(quads, forecast, to);
}

} // namespace ffgpu::work
#endif
