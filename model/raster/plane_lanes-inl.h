// The planes of a run over the lanes of its fragments: the corners of 4 to 16 quads at once, a lane
// a quad, then their lanes. Corners are computed modulo 2^32 in the parts of StoredPlane, which is
// exact as the true value fits. Included once for each instruction set.

#if defined(FFGPU_MODEL_RASTER_PLANE_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef FFGPU_MODEL_RASTER_PLANE_LANES_INL_H
#undef FFGPU_MODEL_RASTER_PLANE_LANES_INL_H
#else
#define FFGPU_MODEL_RASTER_PLANE_LANES_INL_H
#endif

#include "model/raster/interpolator.h"

#include <algorithm>
#include <array>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;
using Halves = hn::Repartition<std::int16_t, Floats>;
using VF = hn::Vec<Floats>;
using VI = hn::Vec<Ints>;

// The lanes of one primitive.
struct LaneRun {
    const SetupRecord& record;
    std::size_t first, end;
};

// Calls body(run) for each run of the batch.
template <class Body>
HWY_INLINE void for_runs(std::span<const BatchRun> runs, const FragmentBatch& batch, Body&& body) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const unsigned end = i + 1 < runs.size() ? runs[i + 1].first_quad : batch.quad_count;
        body(LaneRun{*runs[i].record, std::size_t{4} * runs[i].first_quad, std::size_t{4} * end});
    }
}

// A vector of a batch's lanes from `lane` on. One that would leave the batch is cut off at its end.
HWY_INLINE VF load_lanes(const float* plane, std::size_t lane) {
    const Floats d;
    if (lane + hn::Lanes(d) <= BatchFragments) [[likely]]
        return hn::LoadU(d, plane + lane);
    alignas(64) std::array<float, 16> rest{};
    std::copy(plane + lane, plane + BatchFragments, rest.begin());
    return hn::Load(d, rest.data());
}

template <class D>
HWY_INLINE void store_lanes(D d, hn::Vec<D> value, hn::TFromD<D>* plane, std::size_t lane) {
    if (lane + hn::Lanes(d) <= BatchFragments) [[likely]] {
        hn::StoreU(value, d, plane + lane);
        return;
    }
    alignas(64) std::array<hn::TFromD<D>, 16> rest;
    hn::Store(value, d, rest.data());
    std::copy_n(rest.begin(), BatchFragments - lane, plane + lane);
}

// The lanes of a vector's quads, a vector a quarter of them: the number of each lane's quad.
template <class Number, std::size_t Lanes>
constexpr std::array<Number, Lanes> quad_of_lane() {
    std::array<Number, Lanes> numbers{};
    for (std::size_t i = 0; i < Lanes; ++i)
        numbers[i] = static_cast<Number>(i / 4);
    return numbers;
}
alignas(64) constexpr std::array<std::int32_t, 64> QuadOfLane = quad_of_lane<std::int32_t, 64>();

// Of each pair of halves with another, summed.
HWY_INLINE VI products(hn::Vec<Halves> a, hn::Vec<Halves> b) {
    VI other = hn::Zero(Ints());
    const VI sum = hn::ReorderWidenMulAccumulate(Ints(), a, b, hn::Zero(Ints()), other);
    return hn::RearrangeToOddPlusEven(sum, other);
}

HWY_INLINE hn::Vec<Halves> spread_pair(std::uint32_t pair) {
    return hn::BitCast(Halves(), hn::Set(Words(), pair));
}

// A plane at the corners of the quads at these pairs, relative to the reference pixel. Its parts
// come from the record each time: kept in registers those of four planes would not fit.
HWY_INLINE VI corners_at(const StoredPlane& plane, hn::Vec<Halves> at) {
    constexpr int Low = StoredPlane::LowBits, Middle = StoredPlane::MiddleBits;
    const auto fraction =
        hn::And(hn::Set(Words(), plane.fraction_and_scale), hn::Set(Words(), StoredPlane::LowMask));
    const VI carried = hn::ShiftRight<Low>(
        hn::Add(products(spread_pair(plane.low), at), hn::BitCast(Ints(), fraction)));
    const VI upper = hn::ShiftLeft<Middle>(products(spread_pair(plane.high), at));
    return hn::Add(hn::Add(products(spread_pair(plane.middle), at), upper),
                   hn::Add(hn::Set(Ints(), plane.whole), carried));
}

// What the lanes of a quad have more than its corner.
HWY_INLINE VI offsets_of(const StoredPlane& plane) {
    alignas(16) static constexpr std::int32_t AllButFirst[4] = {0, -1, -1, -1};
    const Ints d;
    const auto* const last = reinterpret_cast<const std::int32_t*>(&plane.high);
    return hn::And(hn::LoadDup128(d, last), hn::LoadDup128(d, AllButFirst));
}

// For vectors that cover the run: calls begin(lane), then body(what that gave, i, integers, lane)
// with the integers of planes first + i from `lane` on.
template <unsigned Count, class Begin, class Body>
HWY_INLINE void for_integers(const LaneRun& run,
                             unsigned first_plane,
                             const PerspectivePlanes& planes,
                             Begin&& begin,
                             Body&& body) {
    constexpr std::size_t N = hn::MaxLanes(Floats());
    const SetupRecord& record = run.record;
    const auto reference = spread_pair(static_cast<std::uint32_t>(record.x_reference & 0xffff) |
                                       static_cast<std::uint32_t>(record.y_reference) << 16);
    const StoredPlane* const stored = record.planes() + first_plane;
    for (std::size_t first = run.first; first < run.end; first += 4 * N) {
        const auto places = hn::LoadU(Words(), planes.places.data() + first / 4);
        const auto at = hn::Sub(hn::BitCast(Halves(), places), reference);
        VI corners[Count];
        for (unsigned i = 0; i < Count; ++i)
            corners[i] = corners_at(stored[i], at);
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const std::size_t lane = first + quarter * N;
            if (lane >= run.end) break;
            const auto quads = hn::SetTableIndices(Ints(), QuadOfLane.data() + quarter * N);
            const auto shared = begin(lane);
            for (unsigned i = 0; i < Count; ++i)
                body(shared,
                     i,
                     hn::Add(hn::TableLookupLanes(corners[i], quads), offsets_of(stored[i])),
                     lane);
        }
    }
}

// Planes `first` and on times `w`, an array of all lanes, and each its scale: body(i, value, lane).
template <unsigned Count, class Body>
HWY_INLINE void for_values(const LaneRun& run,
                           unsigned first,
                           const PerspectivePlanes& planes,
                           const float* w,
                           const std::array<float, Count>& scales,
                           Body&& body) {
    for_integers<Count>(
        run,
        first,
        planes,
        [&](std::size_t lane) HWY_ATTR { return load_lanes(w, lane); },
        [&](VF by, unsigned i, VI integers, std::size_t lane) HWY_ATTR {
            const VF value = hn::Mul(hn::ConvertTo(Floats(), integers), by);
            body(i, hn::Mul(value, hn::Set(Floats(), scales[i])), lane);
        });
}

// The same times 1 / w.
template <unsigned Count, class Body>
HWY_INLINE void
for_planes(const LaneRun& run, unsigned first, const PerspectivePlanes& planes, Body&& body) {
    std::array<float, Count> scales;
    for (unsigned i = 0; i < Count; ++i)
        scales[i] = run.record.planes()[first + i].scale();
    for_values<Count>(run, first, planes, planes.w.data(), scales, body);
}

// The integers of one plane: body(integers, lane).
template <class Body>
HWY_INLINE void
for_integers_of(const LaneRun& run, unsigned plane, const PerspectivePlanes& planes, Body&& body) {
    for_integers<1>(
        run,
        plane,
        planes,
        [](std::size_t) { return 0; },
        [&](int, unsigned, VI integers, std::size_t lane) HWY_ATTR { body(integers, lane); });
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
