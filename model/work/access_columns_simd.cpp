// put_accesses() by vectors: the four lanes of a quad at once, where each has one access, or two.

#include "model/base/simd_targets.h"
#include "model/work/access_columns.h"

#include <array>
#include <cstddef>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/work/access_columns_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::work::HWY_NAMESPACE {
namespace {

// How many lanes of a quad there are in four bits.
constexpr std::array<std::uint8_t, 16> QuadLanes{0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};

#if HWY_TARGET != HWY_SCALAR // Vectors of one lane hold no quad.

namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::FixedTag<std::uint32_t, 4>;
using D16 = hn::FixedTag<std::uint16_t, 8>;
using Words = hn::Vec<D32>;

// A word of the 16 bits at `low` and, above them, those at `high`.
HWY_INLINE Words low_halves(Words low, Words high) {
    return hn::Or(hn::And(low, hn::Set(D32(), 0xffff)), hn::ShiftLeft<16>(high));
}
HWY_INLINE Words high_halves(Words low, Words high) {
    return hn::Or(hn::ShiftRight<16>(low), hn::And(high, hn::Set(D32(), 0xffff0000)));
}
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

// Of four accesses, one of each lane.
struct FourAccesses {
    Words head, x, y, layers; // the words of each
};
struct FourTold {
    alignas(16) std::array<std::uint32_t, 4> shapes, steps; // x, and y above it: zigzag
    std::array<std::uint16_t, 4> layers;                    // expected
    bool all_foreseen, short_steps;                         // Each step is a byte.
};

HWY_INLINE Words lanes_of(Words head) {
    return hn::And(head, hn::Set(D32(), 0xffff));
}

// What put_access() tells of them one after the other, and what is expected behind them.
HWY_INLINE void tell(const FourAccesses& four, AccessForecast::Past& past, FourTold& out) {
    const D32 d;
    const Words one = hn::Set(d, 1), low = hn::Set(d, 0xffff);
    const Words linear = hn::ShiftRight<24>(four.head);
    const Words place = low_halves(four.x, four.y);
    const Words kind =
        hn::Or(hn::And(four.layers, low), hn::And(four.head, hn::Set(d, 0x00ff0000)));
    const Words second = low_halves(hn::And(linear, one), hn::And(hn::ShiftRight<1>(linear), one));
    const Words second_layer =
        difference(hn::ShiftRight<16>(four.layers), hn::And(four.layers, low));
    const Words wrong =
        hn::Or(hn::Or(hn::Xor(kind, references(past.kind, kind)),
                      hn::Xor(difference(high_halves(four.x, four.y), place), second)),
               hn::Xor(second_layer, hn::ShiftRight<2>(linear)));
    const auto foreseen = hn::Eq(wrong, hn::Zero(d));
    const Words from_reference = difference(place, references(past.place, place));
    const Words steps = zigzag_halves(difference(from_reference, hn::Load(d, past.steps.data())));
    hn::Store(steps, d, out.steps.data());
    hn::Store(hn::Or(hn::Or(lanes_of(four.head), hn::ShiftLeft<2>(linear)),
                     hn::IfThenElseZero(foreseen, hn::Set(d, ShapeForeseen))),
              d,
              out.shapes.data());
    out.all_foreseen = hn::AllTrue(d, foreseen);
    out.short_steps = hn::AllTrue(d, hn::Eq(hn::And(steps, hn::Set(d, 0xff80ff80)), hn::Zero(d)));
    const auto layer = static_cast<std::uint16_t>(hn::GetLane(kind));
    out.layers = {static_cast<std::uint16_t>(past.kind), layer, layer, layer};
    hn::Store(from_reference, d, past.steps.data());
    past.place = hn::GetLane(place);
    past.kind = hn::GetLane(kind);
}

// Of `Each` accesses a lane, what is told of lane after lane.
template <unsigned Each>
HWY_INLINE void
put_told(const std::array<FourTold, Each>& told,
         const std::vector<AccessPlane>& planes,
         unsigned quad,
         AccessCursors& to) {
    bool short_steps = true, all_foreseen = true;
    for (const FourTold& one : told) {
        short_steps = short_steps && one.short_steps;
        all_foreseen = all_foreseen && one.all_foreseen;
    }
    for (unsigned i = 0; i < 4 * Each; ++i) {
        const std::uint32_t step = told[i % Each].steps[i / Each];
        to.shape[i] = static_cast<std::uint8_t>(told[i % Each].shapes[i / Each]);
        to.x[i] = static_cast<std::uint8_t>(step);
        to.y[i] = static_cast<std::uint8_t>(step >> 16);
    }
    to.shape += 4 * Each;
    if (short_steps) {
        to.x += 4 * Each;
        to.y += 4 * Each;
    } else {
        for (unsigned i = 0; i < 4 * Each; ++i) {
            const std::uint32_t step = told[i % Each].steps[i / Each];
            to.x = put_number(to.x, step & 0xffff);
            to.y = put_number(to.y, step >> 16);
        }
    }
    if (all_foreseen) return;
    for (unsigned i = 0; i < 4 * Each; ++i)
        if ((told[i % Each].shapes[i / Each] & ShapeForeseen) == 0)
            to.rare = put_rare(to.rare,
                               planes[i % Each].at(4 * quad + i / Each),
                               told[i % Each].layers[i / Each]);
}

// Of all lanes of a quad.
HWY_INLINE FourAccesses load(const AccessPlane& plane, unsigned quad) {
    using Kind = AccessPlane::Words;
    const D32 d;
    const auto words = [&](Kind kind) { return hn::LoadU(d, plane.words(kind) + 4 * quad); };
    const Words heads =
        hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint16_t, D32>(), plane.heads() + 4 * quad));
    return {hn::Or(hn::ShiftLeft<16>(heads), hn::Iota(d, 0)),
            words(Kind::X),
            words(Kind::Y),
            plane.has_layers() ? words(Kind::Layers) : hn::Zero(d)};
}

HWY_INLINE void put_four(const std::vector<AccessPlane>& planes,
                         unsigned quad,
                         AccessForecast::Past* past,
                         AccessCursors& to) {
    *to.number++ = 4;
    std::array<FourTold, 1> told;
    tell(load(planes[0], quad), past[0], told[0]);
    put_told<1>(told, planes, quad, to);
}

HWY_INLINE void put_eight(const std::vector<AccessPlane>& planes,
                          unsigned quad,
                          AccessForecast::Past* past,
                          AccessCursors& to) {
    *to.number++ = 8;
    std::array<FourTold, 2> told;
    tell(load(planes[0], quad), past[0], told[0]);
    tell(load(planes[1], quad), past[1], told[1]);
    put_told<2>(told, planes, quad, to);
}

#endif

void put_others(const TexelFootprints& read,
                unsigned quad,
                AccessForecast& forecast,
                AccessCursors& to) {
    unsigned count = 0;
    for (const AccessPlane& plane : read.planes)
        count += QuadLanes[plane.lanes.quad(quad)];
    to.number = put_number(to.number, count);
    forecast.begin_quad(read.unit);
    for (const TexelAccess& access : read.of_quad(quad))
        put_access(access, forecast, to);
}

HWY_INLINE void put_quad(const TexelFootprints& read,
                         unsigned quad,
                         AccessForecast& forecast,
                         AccessCursors& to) {
#if HWY_TARGET != HWY_SCALAR
    constexpr unsigned All = 0xf;
    const std::vector<AccessPlane>& planes = read.planes;
    const unsigned lanes = planes[0].lanes.quad(quad);
    const unsigned others = planes.size() > 1 ? planes[1].lanes.quad(quad) : 0;
    if (lanes == All && planes.size() <= 2) {
        AccessForecast::Past* const past = &forecast.past(read.unit, 0);
        if (others == 0) return put_four(planes, quad, past, to);
        if (others == All) return put_eight(planes, quad, past, to);
    }
#endif
    put_others(read, quad, forecast, to);
}

AccessCursors PutAccesses(const QuadRange& quads, AccessForecast& forecast, AccessCursors to) {
    const WholeCommand& command = quads.command;
    const std::size_t units = command.units.size();
    for (std::size_t i = quads.first; i < quads.first + quads.count; ++i)
        for (std::size_t unit = 0; unit < units; ++unit) {
            const TexelFootprints* const read = command.footprints_of(i, unit);
            if (read)
                put_quad(*read, command.sources[i].quad, forecast, to);
            else
                *to.number++ = 0;
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

AccessCursors put_accesses(const QuadRange& quads, AccessForecast& forecast, AccessCursors to) {
    return HWY_DYNAMIC_DISPATCH(PutAccesses)(quads, forecast, to);
}

} // namespace ffgpu::work
#endif
