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
// As many fragments at once as a vector has lanes; of short runs, which would leave most of it
// empty, those of two quads or of one.
using Floats = hn::CappedTag<float, 16>;
using PairFloats = hn::CappedTag<float, 8>;
using QuadFloats = hn::CappedTag<float, 4>;
template <class F>
using IntsOf = hn::RebindToSigned<F>;
template <class F>
using WordsOf = hn::RebindToUnsigned<F>;
template <class F>
using HalvesOf = hn::Repartition<std::int16_t, F>;

// The lanes of one primitive.
struct LaneRun {
    const SetupRecord& record;
    std::size_t first, end;
};

// Calls body(run) for each run of a batch.
template <class Body>
HWY_INLINE void for_runs(std::span<const BatchRun> runs, unsigned quad_count, Body&& body) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const unsigned end = i + 1 < runs.size() ? runs[i + 1].first_quad : quad_count;
        body(LaneRun{*runs[i].record, std::size_t{4} * runs[i].first_quad, std::size_t{4} * end});
    }
}

// To a batch's lanes from `lane` on. What would leave the batch is cut off.
template <class D>
HWY_INLINE void store_lanes(D d, hn::Vec<D> value, hn::TFromD<D>* plane, std::size_t lane) {
    if (lane + hn::Lanes(d) <= BatchFragments) [[likely]] {
        hn::StoreU(value, d, plane + lane);
        return;
    }
    const hn::CappedTag<hn::TFromD<D>, 4> quad;
    alignas(64) std::array<hn::TFromD<D>, 64 / sizeof(hn::TFromD<D>)> all;
    hn::Store(value, d, all.data());
    for (std::size_t i = 0; lane + i < BatchFragments; i += 4)
        hn::StoreU(hn::Load(quad, all.data() + i), quad, plane + lane + i);
}

template <class D>
HWY_INLINE void fill(D d, const LaneRun& run, hn::TFromD<D>* plane, hn::TFromD<D> value) {
    for (std::size_t lane = run.first; lane < run.end; lane += hn::Lanes(d))
        store_lanes(d, hn::Set(d, value), plane, lane);
}

template <class T>
HWY_INLINE void fill_run(const LaneRun& run, T* plane, T value) {
    const std::size_t lanes = run.end - run.first;
    if (lanes <= hn::MaxLanes(PairFloats()))
        fill(hn::Rebind<T, PairFloats>(), run, plane, value);
    else if (lanes <= hn::MaxLanes(Floats()))
        fill(hn::Rebind<T, Floats>(), run, plane, value);
    else
        fill(hn::CappedTag<T, 64 / sizeof(T)>(), run, plane, value);
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
template <class H>
HWY_INLINE auto products(H a, H b) {
    const hn::Repartition<std::int32_t, hn::DFromV<H>> d;
    auto other = hn::Zero(d);
    const auto sum = hn::ReorderWidenMulAccumulate(d, a, b, hn::Zero(d), other);
    return hn::RearrangeToOddPlusEven(sum, other);
}

template <class F>
HWY_INLINE hn::Vec<HalvesOf<F>> spread_pair(F, std::uint32_t pair) {
    return hn::BitCast(HalvesOf<F>(), hn::Set(WordsOf<F>(), pair));
}

// A plane at the corners of the quads at these pairs, relative to the reference pixel. Its parts
// come from the record each time: kept in registers those of four planes would not fit.
template <class F>
HWY_INLINE hn::Vec<IntsOf<F>> corners_at(F f, const StoredPlane& plane, hn::Vec<HalvesOf<F>> at) {
    constexpr int Low = StoredPlane::LowBits, Middle = StoredPlane::MiddleBits;
    const IntsOf<F> d;
    const WordsOf<F> words;
    const auto fraction =
        hn::ShiftRight<StoredPlane::FractionShift>(hn::Set(words, plane.fraction_and_scale));
    const auto carried = hn::ShiftRight<Low>(
        hn::Add(products(spread_pair(f, plane.low), at), hn::BitCast(d, fraction)));
    const auto upper = hn::ShiftLeft<Middle>(products(spread_pair(f, plane.high), at));
    return hn::Add(hn::Add(products(spread_pair(f, plane.middle), at), upper),
                   hn::Add(hn::Set(d, plane.whole), carried));
}

// The lanes of quads whose corners these are, one in each lane.
template <class F>
HWY_INLINE hn::Vec<IntsOf<F>> lanes_at(F, const StoredPlane& plane, hn::Vec<IntsOf<F>> corners) {
    alignas(16) static constexpr std::int32_t AllButFirst[4] = {0, -1, -1, -1};
    const IntsOf<F> d;
    const auto* const last = reinterpret_cast<const std::int32_t*>(&plane.high);
    const auto others = hn::MaskFromVec(hn::LoadDup128(d, AllButFirst));
    return hn::Add(corners, hn::IfThenElseZero(others, hn::LoadDup128(d, last)));
}

// The planes from one on, of a run.
struct RunPlanes {
    const LaneRun& run;
    const StoredPlane* stored;
    const std::uint32_t* places; // PerspectivePlanes

    template <class F>
    HWY_INLINE hn::Vec<HalvesOf<F>> places_from(F d, std::size_t lane) const {
        const SetupRecord& record = run.record;
        const auto reference =
            spread_pair(d,
                        static_cast<std::uint32_t>(record.x_reference & 0xffff) |
                            static_cast<std::uint32_t>(record.y_reference) << 16);
        const auto at = hn::LoadU(WordsOf<F>(), places + lane / 4);
        return hn::Sub(hn::BitCast(HalvesOf<F>(), at), reference);
    }
};

// A run that fits a vector: a lane has its quad's place from the start.
template <unsigned Count, class F, class Begin, class Body>
HWY_INLINE void for_few_integers(F d, const RunPlanes& planes, Begin&& begin, Body&& body) {
    const IntsOf<F> ints;
    const std::size_t lane = planes.run.first;
    const auto corners = hn::BitCast(ints, planes.places_from(d, lane));
    const auto quads = hn::SetTableIndices(ints, QuadOfLane.data());
    const auto at = hn::BitCast(HalvesOf<F>(), hn::TableLookupLanes(corners, quads));
    auto shared = begin(d, lane);
    for (unsigned i = 0; i < Count; ++i) {
        const StoredPlane& plane = planes.stored[i];
        body(shared, i, lanes_at(d, plane, corners_at(d, plane, at)), lane);
    }
}

template <unsigned Count, class F, class Begin, class Body>
HWY_INLINE void for_many_integers(F d, const RunPlanes& planes, Begin&& begin, Body&& body) {
    constexpr std::size_t N = hn::MaxLanes(d);
    const IntsOf<F> ints;
    const LaneRun& run = planes.run;
    for (std::size_t first = run.first; first < run.end; first += 4 * N) {
        const auto at = planes.places_from(d, first);
        hn::Vec<IntsOf<F>> corners[Count];
        for (unsigned i = 0; i < Count; ++i)
            corners[i] = corners_at(d, planes.stored[i], at);
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const std::size_t lane = first + quarter * N;
            if (lane >= run.end) break;
            const auto quads = hn::SetTableIndices(ints, QuadOfLane.data() + quarter * N);
            auto shared = begin(d, lane);
            for (unsigned i = 0; i < Count; ++i)
                body(shared,
                     i,
                     lanes_at(d, planes.stored[i], hn::TableLookupLanes(corners[i], quads)),
                     lane);
        }
    }
}

// For vectors that cover the run: calls begin(tag, lane), then body(what that gave, i, integers,
// lane) with the integers of planes first + i from `lane` on.
template <unsigned Count, class Begin, class Body>
HWY_INLINE void for_integers(const LaneRun& run,
                             unsigned first_plane,
                             const PerspectivePlanes& planes,
                             Begin&& begin,
                             Body&& body) {
    const RunPlanes of{run, run.record.planes() + first_plane, planes.places.data()};
    const std::size_t lanes = run.end - run.first;
    if (lanes <= hn::MaxLanes(QuadFloats()))
        for_few_integers<Count>(QuadFloats(), of, begin, body);
    else if (lanes <= hn::MaxLanes(PairFloats()))
        for_few_integers<Count>(PairFloats(), of, begin, body);
    else
        for_many_integers<Count>(Floats(), of, begin, body);
}

// Planes `first` and on times `w`, an array of PaddedLanes, without their scales: body(i, product,
// lane).
template <unsigned Count, class Body>
HWY_INLINE void for_products(const LaneRun& run,
                             unsigned first,
                             const PerspectivePlanes& planes,
                             const float* w,
                             Body&& body) {
    for_integers<Count>(
        run,
        first,
        planes,
        [&](auto d, std::size_t lane) HWY_ATTR { return hn::LoadU(d, w + lane); },
        [&](auto by, unsigned i, auto integers, std::size_t lane) HWY_ATTR {
            const hn::DFromV<decltype(by)> d;
            body(i, hn::Mul(hn::ConvertTo(d, integers), by), lane);
        });
}

template <unsigned Count>
HWY_INLINE std::array<float, Count> scales_of(const LaneRun& run, unsigned first) {
    std::array<float, Count> scales;
    for (unsigned i = 0; i < Count; ++i)
        scales[i] = run.record.planes()[first + i].scale();
    return scales;
}

// The planes' values: times 1 / w, and each its scale: body(i, value, lane).
template <unsigned Count, class Body>
HWY_INLINE void
for_planes(const LaneRun& run, unsigned first, const PerspectivePlanes& planes, Body&& body) {
    const std::array<float, Count> scales = scales_of<Count>(run, first);
    for_products<Count>(run,
                        first,
                        planes,
                        planes.w.data(),
                        [&](unsigned i, auto product, std::size_t lane) HWY_ATTR {
                            const hn::DFromV<decltype(product)> d;
                            body(i, hn::Mul(product, hn::Set(d, scales[i])), lane);
                        });
}

// The integers of one plane: body(integers, lane).
template <class Body>
HWY_INLINE void
for_integers_of(const LaneRun& run, unsigned plane, const PerspectivePlanes& planes, Body&& body) {
    for_integers<1>(
        run,
        plane,
        planes,
        [](auto, std::size_t) { return 0; },
        [&](int, unsigned, auto integers, std::size_t lane) HWY_ATTR { body(integers, lane); });
}

} // namespace
} // namespace ffgpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
