// saved_in_turn() by vectors: sixteen resources in as few as the processor has, and four in one
// more.

#include "model/base/simd_targets.h"
#include "model/timing/memory_turns.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/timing/memory_turns_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::timing::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t WideLanes = Saved::FirstLanes;
constexpr auto Bandwidth = static_cast<std::int32_t>(Saved::lane(Resource::MemoryBandwidth));
static_assert(Saved::Lanes == WideLanes + 4);

// The lanes from `first` on.
template <class D>
HWY_INLINE void
saved_of(D d, std::size_t first, const RequestInTurn& request, SavedInTurn& result) {
    const auto load = [&](const Saved& saved) { return hn::LoadU(d, saved.cycles.data() + first); };
    const auto store = [&](hn::Vec<D> cycles, Saved& saved) {
        hn::StoreU(cycles, d, saved.cycles.data() + first);
    };
    const hn::RebindToSigned<D> numbers;
    const auto lane = hn::Iota(numbers, static_cast<std::int32_t>(first));
    const auto is_bandwidth = hn::RebindMask(d, hn::Eq(lane, hn::Set(numbers, Bandwidth)));
    const auto takes = hn::Set(d, request.takes);
    const auto of_turn = hn::IfThenElseZero(is_bandwidth, takes);
    const auto alone = load(request.alone), asked = load(request.asked);
    auto behind = hn::Set(d, NoTurn);
    auto left = hn::Sub(takes, of_turn);
    for (const RequestInTurn::Before& each : request.before) {
        AnsweredRequest& served = *each.answered;
        const auto mine = each.came_later ? hn::Min(alone, behind) : asked;
        const auto overtakes =
            hn::Gt(hn::Sub(mine, load(served.asked_saved)), hn::Set(d, each.sooner));
        const auto answer = load(served.answer_saved);
        const auto allowed = hn::Add(hn::Add(answer, of_turn), hn::Set(d, each.later));
        behind = hn::IfThenElse(overtakes, behind, hn::Min(behind, allowed));
        if (hn::AllFalse(d, overtakes)) continue;
        const auto idle = load(served.idle);
        const auto used = hn::IfThenElseZero(overtakes, hn::Min(left, idle));
        store(hn::Sub(idle, used), served.idle);
        left = hn::Sub(left, used);
        store(hn::Sub(answer, hn::IfThenElseZero(overtakes, left)), served.answer_saved);
    }
    store(hn::Min(alone, behind), result.answer);
    store(hn::Max(hn::Sub(behind, alone), hn::Zero(d)), result.idle);
}

SavedInTurn saved_in_turn_lanes(const RequestInTurn& request) {
    const hn::CappedTag<float, WideLanes> wide;
    const hn::CappedTag<float, 4> narrow;
    SavedInTurn result;
    for (std::size_t first = 0; first < WideLanes; first += hn::MaxLanes(wide))
        saved_of(wide, first, request, result);
    if (request.has_rare) saved_of(narrow, WideLanes, request, result);
    return result;
}

} // namespace
} // namespace ffgpu::timing::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu::timing {

HWY_EXPORT(saved_in_turn_lanes);

SavedInTurn saved_in_turn(const RequestInTurn& request) {
    return HWY_DYNAMIC_DISPATCH(saved_in_turn_lanes)(request);
}

} // namespace ffgpu::timing
#endif
