// RecentLines by vectors: all lines are compared at once.

#include "model/base/simd_targets.h"
#include "model/work/recent_lines.h"

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/work/recent_lines_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include "model/arith/lanes/mask_bits-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

using work::LineSlots;
using work::RecentLineSlots;
using work::RecentUse;

using Words = hn::CappedTag<std::uint32_t, RecentLineSlots::Count>;
using Halves = hn::CappedTag<std::uint16_t, RecentLineSlots::Count>;
constexpr std::size_t Step = hn::MaxLanes(Words()), HalfStep = hn::MaxLanes(Halves());

// A bit for each slot of which is(first slot of a vector) holds.
template <class Is>
HWY_INLINE LineSlots slots_where(Is&& is) {
    LineSlots slots = 0;
    for (std::size_t at = 0; at < RecentLineSlots::Count; at += Step)
        slots |= static_cast<LineSlots>(bits_from_mask(Words(), is(at)) << at);
    return slots;
}

std::size_t sharers_lanes(const RecentLineSlots& all,
                          LineSlots slots,
                          std::uint64_t line,
                          std::span<std::uint32_t> counts) {
    const Words words;
    const auto own = hn::Set(words, static_cast<std::uint32_t>(line));
    auto set_bits = hn::Set(words, 1u);
    for (std::size_t level = 0; level < counts.size(); ++level) {
        slots &= slots_where([&](std::size_t at) {
            const auto other = hn::Xor(hn::Load(words, all.low.data() + at), own);
            return hn::Eq(hn::And(other, set_bits), hn::Zero(words));
        });
        if (slots == 0) return level;
        counts[level] = static_cast<std::uint32_t>(std::popcount(slots));
        set_bits = hn::Or(hn::Add(set_bits, set_bits), hn::Set(words, 1u));
    }
    return counts.size();
}

RecentUse
use_recent_lanes(RecentLineSlots& all, std::uint64_t line, std::span<std::uint32_t> counts) {
    const Words words;
    const auto low = hn::Set(words, static_cast<std::uint32_t>(line));
    const auto high = hn::Set(words, static_cast<std::uint32_t>(line >> 32));
    const LineSlots here = slots_where([&](std::size_t at) {
        return hn::And(hn::Eq(hn::Load(words, all.low.data() + at), low),
                       hn::Eq(hn::Load(words, all.high.data() + at), high));
    });
    const auto found = static_cast<LineSlots>(here & all.used);
    if (found == 0) return {};
    const auto slot = static_cast<unsigned>(std::countr_zero(found));
    const auto newer = static_cast<LineSlots>(all.newer[slot] & all.used);
    const Halves halves;
    for (std::size_t at = 0; at < RecentLineSlots::Count; at += HalfStep) {
        const auto before = hn::Load(halves, all.newer.data() + at);
        hn::Store(hn::Or(before, hn::Set(halves, found)), halves, all.newer.data() + at);
    }
    all.newer[slot] = 0;
    if (newer == 0) return {slot, 0, 0};
    const auto count = static_cast<std::uint32_t>(std::popcount(newer));
    return {slot, count, sharers_lanes(all, newer, line, counts)};
}

LineSlots left_by_lanes(const RecentLineSlots& all, std::uint32_t left) {
    const hn::RebindToSigned<Words> numbers; // AgeStacks::MostTimes
    const auto most = hn::Set(numbers, static_cast<std::int32_t>(left));
    const LineSlots later = slots_where([&](std::size_t at) {
        const auto own = hn::BitCast(numbers, hn::Load(Words(), all.left.data() + at));
        return hn::RebindMask(Words(), hn::Gt(own, most));
    });
    return static_cast<LineSlots>(all.used & ~later);
}

unsigned oldest_slot_lanes(const RecentLineSlots& all) {
    const Halves halves;
    const auto used = hn::Set(halves, all.used);
    LineSlots slots = 0;
    for (std::size_t at = 0; at < RecentLineSlots::Count; at += HalfStep) {
        const auto own = hn::Shl(hn::Set(halves, std::uint16_t{1}),
                                 hn::Iota(halves, static_cast<std::uint16_t>(at)));
        const auto newer = hn::Load(halves, all.newer.data() + at);
        const auto is = hn::Eq(hn::And(hn::Or(newer, own), used), used);
        slots |= static_cast<LineSlots>(bits_from_mask(halves, is) << at);
    }
    return static_cast<unsigned>(std::countr_zero(static_cast<LineSlots>(slots & all.used)));
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu::work {
namespace {
HWY_EXPORT(sharers_lanes);
HWY_EXPORT(use_recent_lanes);
HWY_EXPORT(left_by_lanes);
HWY_EXPORT(oldest_slot_lanes);
} // namespace

std::size_t sharers(const RecentLineSlots& all,
                    LineSlots slots,
                    std::uint64_t line,
                    std::span<std::uint32_t> counts) {
    return HWY_DYNAMIC_DISPATCH(sharers_lanes)(all, slots, line, counts);
}

RecentUse use_recent(RecentLineSlots& all, std::uint64_t line, std::span<std::uint32_t> counts) {
    return HWY_DYNAMIC_DISPATCH(use_recent_lanes)(all, line, counts);
}

LineSlots left_by(const RecentLineSlots& all, std::uint32_t left) {
    return HWY_DYNAMIC_DISPATCH(left_by_lanes)(all, left);
}

unsigned oldest_slot(const RecentLineSlots& all) {
    return HWY_DYNAMIC_DISPATCH(oldest_slot_lanes)(all);
}

} // namespace ffgpu::work
#endif
