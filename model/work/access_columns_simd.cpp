// put_accesses() by vectors: the lanes of a quad at once, where each that has accesses has one, or
// each two.

#include "model/base/simd_targets.h"
#include "model/work/access_columns.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

constexpr std::uint32_t LongSteps = 0xff80ff80; // Bits of a zigzag step that takes no byte alone.

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
// Of a quad, which lanes of it have accesses, for what is done with them.
struct LanePattern {
    alignas(16) std::array<std::uint32_t, 4> first{};  // All bits, in the first of them ...
    alignas(16) std::array<std::uint32_t, 4> others{}; // ... and in the others.
    // Where bytes come from: each word the first lane's; the lowest bytes of the lanes' words, and
    // in the upper half those of their upper halves, one behind the other, or with gaps of a byte.
    alignas(16) std::array<std::uint8_t, 16> first_word{}, bytes{}, spread_bytes{};
    unsigned count = 0;

    explicit constexpr LanePattern(unsigned lanes) {
        constexpr std::uint8_t None = 0x80;
        bytes.fill(None);
        spread_bytes.fill(None);
        unsigned first_lane = 0;
        for (unsigned lane = 0; lane < 4; ++lane) {
            if ((lanes >> lane & 1) == 0) continue;
            if (count == 0) first_lane = lane;
            (count == 0 ? first : others)[lane] = ~0u;
            bytes[count] = spread_bytes[2 * count] = static_cast<std::uint8_t>(4 * lane);
            bytes[8 + count] = spread_bytes[8 + 2 * count] =
                static_cast<std::uint8_t>(4 * lane + 2);
            ++count;
        }
        for (unsigned i = 0; i < 16; ++i)
            first_word[i] = static_cast<std::uint8_t>(4 * first_lane + i % 4);
    }
};

constexpr auto LanePatterns = []<std::size_t... Lanes>(std::index_sequence<Lanes...>) {
    return std::array{LanePattern(Lanes)...};
}
(std::make_index_sequence<16>());

HWY_INLINE Words load(const std::array<std::uint32_t, 4>& words) {
    return hn::Load(D32(), words.data());
}
HWY_INLINE Words bytes_at(Words words, const std::array<std::uint8_t, 16>& places) {
    const hn::Repartition<std::uint8_t, D32> d;
    return hn::BitCast(D32(),
                       hn::TableLookupBytesOr0(hn::BitCast(d, words), hn::Load(d, places.data())));
}
HWY_INLINE Words selected(Words mask, Words yes, Words no) {
    return hn::Or(hn::And(mask, yes), hn::AndNot(mask, no));
}

// The words of a quad's accesses, one each of its lanes.
struct QuadAccesses {
    Words heads, x, y, layers; // heads: AccessPlane::heads
};

HWY_INLINE QuadAccesses load(const AccessPlane& plane, unsigned quad) {
    using Kind = AccessPlane::Words;
    const D32 d;
    const auto words = [&](Kind kind) { return hn::LoadU(d, plane.words(kind) + 4 * quad); };
    return {hn::PromoteTo(d, hn::LoadU(hn::Rebind<std::uint16_t, D32>(), plane.heads() + 4 * quad)),
            words(Kind::X),
            words(Kind::Y),
            plane.has_layers() ? words(Kind::Layers) : hn::Zero(d)};
}

// Of lanes without an access it means nothing.
struct Told {
    Words shapes, steps; // zigzag: x, and y above it
    Words wrong;         // 0: as foreseen
    Words level;
    Words seconds, layers; // by how much x1 and y1, layer0 and layer1 are not as foreseen
    Words kind;            // expected
};

// What put_access() tells of them one after the other, and what is expected behind them.
HWY_INLINE Told tell(const QuadAccesses& four,
                     const LanePattern& pattern,
                     AccessForecast::Past& past) {
    const D32 d;
    const Words one = hn::Set(d, 1), low = hn::Set(d, 0xffff);
    const Words first = load(pattern.first);
    const Words linear = hn::ShiftRight<8>(four.heads);
    const Words place = low_halves(four.x, four.y);
    const Words level = hn::AndNot(low, hn::ShiftLeft<16>(hn::And(four.heads, hn::Set(d, 0xff))));
    const Words kind = hn::Or(hn::And(four.layers, low), level);
    const Words second = low_halves(hn::And(linear, one), hn::And(hn::ShiftRight<1>(linear), one));
    const Words second_layer =
        difference(hn::ShiftRight<16>(four.layers), hn::And(four.layers, low));
    const Words first_kind = bytes_at(kind, pattern.first_word);
    const Words first_place = bytes_at(place, pattern.first_word);
    const Words expected_kind = selected(first, hn::Set(d, past.kind), first_kind);
    const Words seconds = difference(difference(high_halves(four.x, four.y), place), second);
    const Words layers = low_halves(difference(four.layers, expected_kind),
                                    difference(second_layer, hn::ShiftRight<2>(linear)));
    const Words wrong = hn::Or(hn::Xor(kind, expected_kind), hn::Or(seconds, layers));
    const auto foreseen = hn::Eq(wrong, hn::Zero(d));
    const Words from_reference =
        difference(place, selected(first, hn::Set(d, past.place), first_place));
    const Words steps_before = load(past.steps);
    const Words expected = selected(first, hn::Broadcast<0>(steps_before), steps_before);
    const Words steps_now = selected(load(pattern.others), from_reference, steps_before);
    hn::Store(
        hn::InsertLane(steps_now, 0, hn::GetLane(bytes_at(from_reference, pattern.first_word))),
        d,
        past.steps.data());
    const Told told{hn::Or(hn::Or(hn::Iota(d, 0), hn::ShiftLeft<2>(linear)),
                           hn::IfThenElseZero(foreseen, hn::Set(d, ShapeForeseen))),
                    zigzag_halves(difference(from_reference, expected)),
                    wrong,
                    hn::And(four.heads, hn::Set(d, 0xff)),
                    seconds,
                    layers,
                    expected_kind};
    past.place = hn::GetLane(first_place);
    past.kind = hn::GetLane(first_kind);
    return told;
}

// The bytes of `Each` vectors, lane after lane.
template <unsigned Each>
HWY_INLINE Words told_bytes(const Words (&words)[Each], const LanePattern& pattern) {
    if constexpr (Each == 1) return bytes_at(words[0], pattern.bytes);
    const auto second = hn::BitCast(D16(), bytes_at(words[Each - 1], pattern.spread_bytes));
    return hn::Or(bytes_at(words[0], pattern.spread_bytes),
                  hn::BitCast(D32(), hn::ShiftLeft<8>(second)));
}

// The lower half of the vector, as far as `Each` accesses a lane need it.
template <unsigned Each>
HWY_INLINE void store_bytes(Words bytes, std::uint8_t* to) {
    const std::uint64_t eight = hn::GetLane(hn::BitCast(hn::FixedTag<std::uint64_t, 2>(), bytes));
    std::memcpy(to, &eight, 4 * Each);
}

using LaneWords = std::array<std::uint32_t, 4>;

HWY_INLINE LaneWords lanes_of(Words words) {
    alignas(16) LaneWords lanes;
    hn::Store(words, D32(), lanes.data());
    return lanes;
}

// Calls each(number of the access, lane) for those of the lanes.
template <unsigned Each, class Call>
HWY_INLINE void for_each_access(unsigned lanes, Call&& each) {
    for (unsigned lane = 0; lane < 4; ++lane)
        if ((lanes >> lane & 1) != 0)
            for (unsigned i = 0; i < Each; ++i)
                each(i, lane);
}

template <unsigned Each>
void put_long_steps(const Words (&steps)[Each], unsigned lanes, AccessCursors& to) {
    LaneWords of[Each];
    for (unsigned i = 0; i < Each; ++i)
        of[i] = lanes_of(steps[i]);
    for_each_access<Each>(lanes, [&](unsigned i, unsigned lane) {
        to.x = put_number(to.x, of[i][lane] & 0xffff);
        to.y = put_number(to.y, of[i][lane] >> 16);
    });
}

// put_rare() of those that are not foreseen, where each of their numbers is a byte, at once.
template <unsigned Each>
HWY_INLINE void put_rare_lanes(const Told (&told)[Each],
                               const AccessPlane* planes,
                               unsigned quad,
                               unsigned lanes,
                               AccessCursors& to) {
    const D32 d;
    const LanePattern& pattern = LanePatterns[lanes];
    LaneWords wrong[Each], four[Each], fifth[Each];
    Words all = hn::Zero(d);
    for (unsigned i = 0; i < Each; ++i) {
        const Words seconds = zigzag_halves(told[i].seconds),
                    layers = zigzag_halves(told[i].layers);
        all = hn::Or(all, hn::Or(seconds, layers));
        wrong[i] = lanes_of(told[i].wrong);
        four[i] = lanes_of(hn::Or(hn::Or(told[i].level, hn::And(seconds, hn::Set(d, 0x00ff0000))),
                                  hn::Or(hn::ShiftLeft<8>(hn::And(seconds, hn::Set(d, 0xff))),
                                         hn::ShiftLeft<24>(layers))));
        fifth[i] = lanes_of(hn::ShiftRight<16>(layers));
    }
    const Words there = hn::Or(load(pattern.first), load(pattern.others));
    all = hn::And(hn::And(all, there), hn::Set(d, LongSteps));
    if (hn::AllTrue(d, hn::Eq(all, hn::Zero(d)))) {
        for_each_access<Each>(lanes, [&](unsigned i, unsigned lane) {
            std::memcpy(to.rare, &four[i][lane], 4);
            to.rare[4] = static_cast<std::uint8_t>(fifth[i][lane]);
            to.rare += wrong[i][lane] != 0 ? 5 : 0;
        });
        return;
    }
    LaneWords kind[Each];
    for (unsigned i = 0; i < Each; ++i)
        kind[i] = lanes_of(told[i].kind);
    for_each_access<Each>(lanes, [&](unsigned i, unsigned lane) {
        if (wrong[i][lane] != 0)
            to.rare = put_rare(
                to.rare, planes[i].at(4 * quad + lane), static_cast<std::uint16_t>(kind[i][lane]));
    });
}

// `Each` accesses of each of the lanes.
template <unsigned Each>
HWY_INLINE void put_lanes(const AccessPlane* planes,
                          unsigned quad,
                          unsigned lanes,
                          AccessForecast::Past* past,
                          AccessCursors& to) {
    const D32 d;
    const LanePattern& pattern = LanePatterns[lanes];
    Told told[Each];
    Words shapes[Each], steps[Each];
    Words wrong = hn::Zero(d), all_steps = hn::Zero(d);
    for (unsigned i = 0; i < Each; ++i) {
        told[i] = tell(load(planes[i], quad), pattern, past[i]);
        shapes[i] = told[i].shapes;
        steps[i] = told[i].steps;
        wrong = hn::Or(wrong, told[i].wrong);
        all_steps = hn::Or(all_steps, steps[i]);
    }
    const Words there = hn::Or(load(pattern.first), load(pattern.others));
    const auto none = [&](Words words) {
        return hn::AllTrue(d, hn::Eq(hn::And(words, there), hn::Zero(d)));
    };
    const unsigned count = Each * pattern.count;
    *to.number++ = static_cast<std::uint8_t>(count);
    store_bytes<Each>(told_bytes<Each>(shapes, pattern), to.shape);
    to.shape += count;
    if (none(hn::And(all_steps, hn::Set(d, LongSteps)))) {
        const Words bytes = told_bytes<Each>(steps, pattern);
        store_bytes<Each>(bytes, to.x);
        store_bytes<Each>(hn::Shuffle1032(bytes), to.y);
        to.x += count;
        to.y += count;
    } else {
        put_long_steps<Each>(steps, lanes, to);
    }
    if (!none(wrong)) put_rare_lanes<Each>(told, planes, quad, lanes, to);
}

#endif

void put_others(const TexelFootprints& read,
                unsigned quad,
                AccessForecast& forecast,
                AccessCursors& to) {
    unsigned count = 0;
    for (const AccessPlane& plane : read.planes)
        count += static_cast<unsigned>(std::popcount(plane.lanes.quad(quad)));
    to.number = put_number(to.number, count);
    AccessForecast::Quad of_quad = forecast.quad(read.unit);
    for (const TexelAccess& access : read.of_quad(quad))
        put_access(access, of_quad, to);
}

HWY_INLINE void
put_quad(const TexelFootprints& read, unsigned quad, AccessForecast& forecast, AccessCursors& to) {
#if HWY_TARGET != HWY_SCALAR
    const AccessPlane* const planes = read.planes.data();
    const std::size_t count = read.planes.size();
    const unsigned lanes = planes[0].lanes.quad(quad);
    const unsigned seconds = count > 1 ? planes[1].lanes.quad(quad) : 0;
    if (count <= 2 && lanes != 0) {
        AccessForecast::Past* const past = &forecast.past(read.unit, 0);
        if (seconds == 0) return put_lanes<1>(planes, quad, lanes, past, to);
        if (seconds == lanes) return put_lanes<2>(planes, quad, lanes, past, to);
    }
#endif
    put_others(read, quad, forecast, to);
}

// Quads of a row come from batch after batch, and what another thread wrote of them comes late.
constexpr std::size_t Ahead = 12;

HWY_INLINE void fetch_ahead(const WholeCommand& command, std::size_t quad, std::size_t unit) {
    if (quad >= command.sources.size()) return;
    const TexelFootprints* const read = command.footprints_of(quad, unit);
    if (!read) return;
    for (const AccessPlane& plane : read->planes) {
        const unsigned lane = 4 * command.sources[quad].quad;
        __builtin_prefetch(plane.words(AccessPlane::Words::X) + lane);
        __builtin_prefetch(plane.words(AccessPlane::Words::Y) + lane);
        __builtin_prefetch(plane.heads() + lane);
    }
}

AccessCursors PutAccesses(const QuadRange& quads, AccessForecast& forecast, AccessCursors to) {
    const WholeCommand& command = quads.command;
    const std::size_t units = command.units.size();
    for (std::size_t i = quads.first; i < quads.first + quads.count; ++i)
        for (std::size_t unit = 0; unit < units; ++unit) {
            fetch_ahead(command, i + Ahead, unit);
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
