// AgeStacks by vectors: a group of entries is compared at once.

#include "model/base/simd_targets.h"
#include "model/work/age_stacks.h"

#include <algorithm>
#include <array>

// Highway's order of includes.
// clang-format off
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/work/age_stacks_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using work::AgeRows;

using Entries = hn::CappedTag<AgeRows::Entry, AgeRows::Group>;
constexpr std::uint32_t Step = hn::MaxLanes(Entries()), Group = AgeRows::Group;

constexpr auto OneFurther = [] {
    std::array<std::int32_t, Step> lanes{};
    for (std::uint32_t lane = 1; lane < Step; ++lane)
        lanes[lane] = static_cast<std::int32_t>(lane) - 1;
    return lanes;
}();

HWY_INLINE std::uint32_t later_in_group(const AgeRows::Entry* group, AgeRows::Entry latest) {
    const Entries entries;
    std::size_t later = 0;
    for (std::uint32_t at = 0; at < Group; at += Step)
        later +=
            hn::CountTrue(entries, hn::Gt(hn::Load(entries, group + at), hn::Set(entries, latest)));
    return static_cast<std::uint32_t>(later);
}

// Most lines stand in the first group.
HWY_INLINE std::uint32_t
position_in(const AgeRows& rows, const AgeRows::Entry* stack, AgeRows::Entry latest) {
    std::uint32_t later = later_in_group(stack, latest);
    if (later < Group) return later;
    if (stack[rows.depth - 1] > latest) return rows.depth;
    std::uint32_t at = Group;
    while ((later = later_in_group(stack + at, latest)) == Group)
        at += Group;
    return at + later;
}

std::size_t positions_lanes(const AgeRows& rows,
                            std::uint64_t line,
                            AgeRows::Entry latest,
                            std::span<std::uint32_t> positions) {
    for (std::size_t level = 0; level < rows.levels; ++level) {
        positions[level] = position_in(rows, rows.of(level, line), latest);
        if (positions[level] == 0) return level;
    }
    return rows.levels;
}

// What is stored is whole vectors in their places, which later loads need not wait for.
HWY_INLINE void insert(AgeRows::Entry* stack, std::uint32_t moved, AgeRows::Entry newest) {
    const Entries entries;
    const auto beside = [&](hn::Vec<Entries> further, std::uint32_t at, std::uint32_t count) {
        return hn::IfThenElse(hn::FirstN(entries, count), further, hn::Load(entries, stack + at));
    };
    const auto shifted = hn::TableLookupLanes(hn::Load(entries, stack),
                                              hn::SetTableIndices(entries, OneFurther.data()));
    auto first = hn::IfThenElse(hn::FirstN(entries, 1), hn::Set(entries, newest), shifted);
    std::uint32_t at = moved / Step * Step; // of the last that change
    if (at == 0) {
        first = beside(first, 0, moved + 1);
    } else {
        const auto last = beside(hn::LoadU(entries, stack + at - 1), at, moved - at + 1);
        hn::Store(last, entries, stack + at);
        while ((at -= Step) > 0)
            hn::Store(hn::LoadU(entries, stack + at - 1), entries, stack + at);
    }
    hn::Store(first, entries, stack);
}

void move_to_front_lanes(const AgeRows& rows,
                         std::uint64_t line,
                         AgeRows::Entry latest,
                         AgeRows::Entry newest) {
    for (std::size_t level = 0; level < rows.levels; ++level) {
        AgeRows::Entry* const stack = rows.of(level, line);
        const std::uint32_t at = position_in(rows, stack, latest);
        if (at == 0 && latest > AgeRows::Hole) return;
        insert(stack, std::min(at, rows.depth - 1), newest);
    }
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu::work {
namespace {
HWY_EXPORT(positions_lanes);
HWY_EXPORT(move_to_front_lanes);
} // namespace

std::size_t positions_in(const AgeRows& rows,
                         std::uint64_t line,
                         AgeRows::Entry latest,
                         std::span<std::uint32_t> positions) {
    return HWY_DYNAMIC_DISPATCH(positions_lanes)(rows, line, latest, positions);
}

void move_to_front(const AgeRows& rows,
                   std::uint64_t line,
                   AgeRows::Entry latest,
                   AgeRows::Entry newest) {
    HWY_DYNAMIC_DISPATCH(move_to_front_lanes)(rows, line, latest, newest);
}

} // namespace ffgpu::work
#endif
