// What dependences save, by vectors: sixteen resources in as few as the processor has, and four in
// one more.

#include "model/base/simd_targets.h"
#include "model/timing/moment.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/timing/moment_simd.cpp"
#include "hwy/foreach_target.h" // must come first
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace ffgpu::timing::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t WideLanes = Saved::FirstLanes;
static_assert(Saved::Lanes == WideLanes + 4);

// By resources: all bits in its lane. Rows begin at vectors.
struct alignas(64) LaneBits : std::array<std::int32_t, 32> {};
constexpr std::array<LaneBits, Resources> OwnLane = [] {
    std::array<LaneBits, Resources> bits{};
    for (std::size_t i = 0; i < Resources; ++i)
        bits[i][Saved::lane(static_cast<Resource>(i))] = -1;
    return bits;
}();

// `cycles` in the lane of the part's resource, nothing in the others.
template <class D>
HWY_INLINE hn::Vec<D> lanes_of(D d, std::size_t first, const Dependence::Part& part) {
    const hn::RebindToSigned<D> numbers;
    const std::int32_t* const own = OwnLane[static_cast<std::size_t>(part.resource)].data() + first;
    return hn::And(hn::BitCast(d, hn::Load(numbers, own)), hn::Set(d, part.cycles));
}

// Lanes from `first` on of what one dependence allows.
template <class D>
HWY_INLINE hn::Vec<D> allowed(D d, std::size_t first, const Dependence& by, float more) {
    auto saved = hn::LoadU(d, by.moment->saved.cycles.data() + first);
    saved = hn::Add(saved, lanes_of(d, first, by.first));
    if (by.then.cycles != 0) saved = hn::Add(saved, lanes_of(d, first, by.then)); // seldom
    return hn::Add(saved, hn::Set(d, more));
}

template <bool has_rare>
void saved_after_lanes(const Dependences& all, Saved& result) {
    const hn::CappedTag<float, WideLanes> wide;
    const hn::CappedTag<float, 4> narrow;
    constexpr std::size_t Step = hn::MaxLanes(wide), Vectors = WideLanes / Step;
    const float least = all.least();
    std::array<hn::Vec<decltype(wide)>, Vectors> saved;
    for (std::size_t i = 0; i < Vectors; ++i)
        saved[i] = allowed(wide, i * Step, all[0], all.slack_of(0) - least);
    auto rest = hn::Zero(narrow);
    if constexpr (has_rare) rest = allowed(narrow, WideLanes, all[0], all.slack_of(0) - least);
    for (std::size_t place = 1; place < all.count(); ++place) {
        const Dependence& each = all[place];
        const float more = all.slack_of(place) - least;
        for (std::size_t i = 0; i < Vectors; ++i)
            saved[i] = hn::Min(allowed(wide, i * Step, each, more), saved[i]);
        if constexpr (has_rare) rest = hn::Min(allowed(narrow, WideLanes, each, more), rest);
    }
    for (std::size_t i = 0; i < Vectors; ++i)
        hn::StoreU(saved[i], wide, result.cycles.data() + i * Step);
    if constexpr (has_rare) hn::StoreU(rest, narrow, result.cycles.data() + WideLanes);
}

void saved_after_each(const Dependences& all, Saved& result) {
    all.has_rare() ? saved_after_lanes<true>(all, result) : saved_after_lanes<false>(all, result);
}

} // namespace
} // namespace ffgpu::timing::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu::timing {

HWY_EXPORT(saved_after_each);

SavedAfter saved_after_by_vectors() {
    if (!hwy::GetChosenTarget().IsInitialized())
        hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    return &HWY_DYNAMIC_DISPATCH(saved_after_each);
}

} // namespace ffgpu::timing
#endif
