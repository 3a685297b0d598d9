// The fast form of the interpolator: the corners of 4 to 16 quads of a run, a lane a quad, then as
// many fragments at once. Corners are computed modulo 2^32 in the parts of StoredPlane, which is
// exact as the true value fits.
//
// Runs go in ascending order and a vector may run over the end of its run: those lanes belong to
// the next run, which writes them afterwards, or to nobody.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/interpolator_simd.cpp"

#include "model/arith/range.h"
#include "model/raster/interpolator.h"
#include "model/raster/sample_positions.h"

#include <algorithm>
#include <array>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

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
constexpr std::array<std::int32_t, 64> make_quad_of_lane() {
    std::array<std::int32_t, 64> numbers{};
    for (unsigned i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<std::int32_t>(i / 4);
    return numbers;
}
alignas(64) constexpr std::array<std::int32_t, 64> QuadOfLane = make_quad_of_lane();

// A plane, spread over lanes.
class RunPlane {
public:
    HWY_INLINE void spread(const StoredPlane& plane) {
        alignas(16) static constexpr std::int32_t AllButFirst[4] = {0, -1, -1, -1};
        const Ints d;
        low_ = pairs(plane.low);
        middle_ = pairs(plane.middle);
        high_ = pairs(plane.high);
        const auto fraction = hn::Set(Words(), plane.fraction_and_scale);
        fraction_ = hn::BitCast(d, hn::And(fraction, hn::Set(Words(), StoredPlane::LowMask)));
        whole_ = hn::Set(d, plane.whole);
        const auto* const last = reinterpret_cast<const std::int32_t*>(&plane.high);
        offsets_ = hn::And(hn::LoadDup128(d, last), hn::LoadDup128(d, AllButFirst));
    }

    // The corners of the quads at these pairs, relative to the reference pixel.
    HWY_INLINE VI corners(hn::Vec<Halves> at) const {
        constexpr int Low = StoredPlane::LowBits, Middle = StoredPlane::MiddleBits;
        const VI carried = hn::ShiftRight<Low>(hn::Add(products(low_, at), fraction_));
        const VI upper = hn::ShiftLeft<Middle>(products(high_, at));
        return hn::Add(hn::Add(products(middle_, at), upper), hn::Add(whole_, carried));
    }
    // The integers of those of their lanes whose quads have these numbers.
    template <class Numbers>
    HWY_INLINE VI lanes(VI corners, Numbers quads) const {
        return hn::Add(hn::TableLookupLanes(corners, quads), offsets_);
    }

    static HWY_INLINE hn::Vec<Halves> pairs(std::uint32_t pair) {
        return hn::BitCast(Halves(), hn::Set(Words(), pair));
    }

private:
    // Of each pair with another, summed.
    static HWY_INLINE VI products(hn::Vec<Halves> a, hn::Vec<Halves> b) {
        VI other = hn::Zero(Ints());
        const VI sum = hn::ReorderWidenMulAccumulate(Ints(), a, b, hn::Zero(Ints()), other);
        return hn::RearrangeToOddPlusEven(sum, other);
    }

    hn::Vec<Halves> low_, middle_, high_;
    VI fraction_, whole_, offsets_;
};

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
    const auto reference = RunPlane::pairs(static_cast<std::uint32_t>(record.x_reference & 0xffff) |
                                           static_cast<std::uint32_t>(record.y_reference) << 16);
    RunPlane plane[Count];
    for (unsigned i = 0; i < Count; ++i)
        plane[i].spread(record.planes()[first_plane + i]);
    for (std::size_t first = run.first; first < run.end; first += 4 * N) {
        const auto places = hn::LoadU(Words(), planes.places.data() + first / 4);
        const auto at = hn::Sub(hn::BitCast(Halves(), places), reference);
        VI corners[Count];
        for (unsigned i = 0; i < Count; ++i)
            corners[i] = plane[i].corners(at);
        for (std::size_t quarter = 0; quarter < 4; ++quarter) {
            const std::size_t lane = first + quarter * N;
            if (lane >= run.end) break;
            const auto quads = hn::SetTableIndices(Ints(), QuadOfLane.data() + quarter * N);
            const auto shared = begin(lane);
            for (unsigned i = 0; i < Count; ++i)
                body(shared, i, plane[i].lanes(corners[i], quads), lane);
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

HWY_INLINE void store_color(VF value, std::uint16_t* plane, std::size_t lane) {
    const Floats d;
    const auto clamped = hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 255.0f));
    const hn::Rebind<std::uint16_t, Floats> halves;
    const auto rounded = hn::ConvertTo(Ints(), hn::Add(clamped, hn::Set(d, 0.5f)));
    store_lanes(halves, hn::DemoteTo(halves, rounded), plane, lane);
}

void fill(std::uint16_t* plane, std::size_t first, std::size_t end, std::uint16_t value) {
    for (std::size_t lane = first; lane < end; ++lane)
        plane[lane] = value;
}

// A colour whose planes stand at `first` in the layout.
template <unsigned Channels>
void color_run(const LaneRun& run,
               int first,
               const std::uint8_t* constant,
               const PerspectivePlanes& planes,
               const std::array<std::uint16_t*, Channels>& out) {
    if (constant) {
        for (std::size_t i = 0; i < Channels; ++i)
            fill(out[i], run.first, run.end, constant[i]);
        return;
    }
    for_planes<Channels>(run,
                         static_cast<unsigned>(first),
                         planes,
                         [&](unsigned i, VF value, std::size_t lane)
                             HWY_ATTR { store_color(value, out[i], lane); });
}

// At the point that lies `position` (1/256 pixel) beside each centre.
HWY_INLINE void depth_beside(SubPixelPoint position,
                             std::span<const BatchRun> runs,
                             const FragmentBatch& batch,
                             std::uint32_t* out) {
    const hn::CappedTag<std::int64_t, 4> d;
    const hn::RebindToUnsigned<decltype(d)> wide;
    const hn::Rebind<std::uint32_t, decltype(d)> narrow;
    constexpr auto Half = std::int64_t{1} << (DepthPlane::FractionBits - 1);
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const SetupRecord& record = run.record;
        const DepthPlane& plane = record.depth;
        const std::int64_t base_offset = Half + plane.beside(position);
        alignas(32) const std::int64_t offsets[4] = {base_offset,
                                                     base_offset + plane.dx,
                                                     base_offset + plane.dy,
                                                     base_offset + plane.dx + plane.dy};
        const auto lowest = hn::Set(d, std::int64_t{record.depth_min});
        const auto highest = hn::Set(d, std::int64_t{record.depth_max});
        for (std::size_t lane = run.first; lane < run.end; lane += 4) {
            const auto base = hn::Set(d,
                                      plane.at(batch.x[lane / 4] - record.x_reference,
                                               batch.y[lane / 4] - record.y_reference));
            for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
                const auto sum = hn::Add(base, hn::Load(d, offsets + i));
                const auto depth = hn::ShiftRight<DepthPlane::FractionBits>(sum);
                const auto clamped = hn::Min(hn::Max(depth, lowest), highest);
                hn::StoreU(
                    hn::TruncateTo(narrow, hn::BitCast(wide, clamped)), narrow, out + lane + i);
            }
        }
    });
}

void InterpolateDepth(std::span<const BatchRun> runs, FragmentBatch& batch) {
    depth_beside({}, runs, batch, batch.depth.data());
}

void InterpolateSampleDepths(std::span<const BatchRun> runs,
                             const FragmentBatch& batch,
                             SampleDepths& depths) {
    for (unsigned i = 0; i < MaxSamples; ++i)
        depth_beside(SamplePositions[i], runs, batch, depths.of[i].data());
}

void place_quads(const FragmentBatch& batch, PerspectivePlanes& planes) {
    for (std::size_t q = 0; q < BatchQuads; ++q)
        planes.places[q] = batch.x[q] | static_cast<std::uint32_t>(batch.y[q]) << 16;
}

void InterpolatePerspective(std::span<const BatchRun> runs,
                            const FragmentBatch& batch,
                            PerspectivePlanes& planes) {
    const Floats d;
    place_quads(batch, planes);
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const SetupRecord& record = run.record;
        if (!record.perspective) {
            std::fill(planes.w.begin() + run.first, planes.w.begin() + run.end, 1.0f);
            return;
        }
        const VI floor = hn::Set(Ints(), record.inverse_w_floor);
        for_integers_of(
            run, record.plane_count, planes, [&](VI integers, std::size_t lane) HWY_ATTR {
                const VF inverse = hn::ConvertTo(d, hn::Max(integers, floor));
                store_lanes(d, hn::Div(hn::Set(d, 1.0f), inverse), planes.w.data(), lane);
            });
    });
}

HWY_INLINE VF in_fog_range_lanes(VF value) {
    const Floats d;
    const auto large = hn::Min(hn::Max(value, hn::Set(d, -LargestFog)), hn::Set(d, LargestFog));
    return hn::IfThenElseZero(hn::Ge(hn::Abs(value), hn::Set(d, LeastFog)), large);
}

void InterpolateColors(const InterpolantLayout& layout,
                       std::span<const BatchRun> runs,
                       const PerspectivePlanes& planes,
                       FragmentBatch& batch) {
    ColorPlanes& one = batch.primary;
    ColorPlanes& two = batch.secondary;
    const std::array<std::uint16_t*, 4> primary{
        one.r.data(), one.g.data(), one.b.data(), one.a.data()};
    const std::array<std::uint16_t*, 3> secondary{two.r.data(), two.g.data(), two.b.data()};
    if (layout.secondary >= 0) fill(two.a.data(), 0, batch.lanes(), 0);
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const SetupRecord& record = run.record;
        const auto constant = [](bool is, const std::array<std::uint8_t, 4>& color) {
            return is ? color.data() : nullptr;
        };
        if (layout.color >= 0)
            color_run<4>(
                run, layout.color, constant(record.constant_color, record.color), planes, primary);
        if (layout.secondary >= 0)
            color_run<3>(run,
                         layout.secondary,
                         constant(record.constant_secondary, record.secondary),
                         planes,
                         secondary);
        if (layout.fog >= 0)
            for_planes<1>(run,
                          static_cast<unsigned>(layout.fog),
                          planes,
                          [&](unsigned, VF value, std::size_t lane) HWY_ATTR {
                              store_lanes(Floats(),
                                          in_fog_range_lanes(value),
                                          batch.fog_coordinate.data(),
                                          lane);
                          });
    });
}

// What no plane carries is 0.
HWY_INLINE std::array<float*, 3>
begin_coordinates(const TexCoordSource& source, unsigned lanes, TexCoordPlanes& out) {
    const std::array<float*, 3> all{out.s.data(), out.t.data(), out.r.data()};
    for (unsigned i = source.coordinates(); i < 3; ++i)
        for (unsigned lane = 0; lane < lanes; ++lane)
            all[i][lane] = 0;
    return all;
}

// The planes over that of q.
void divided_run(const LaneRun& run,
                 const TexCoordSource& source,
                 const PerspectivePlanes& planes,
                 const std::array<float*, 3>& out) {
    const Floats d;
    alignas(64) std::array<float, BatchFragments> over_q;
    const unsigned q = source.first + 3;
    for_integers_of(run, q, planes, [&](VI integers, std::size_t lane) HWY_ATTR {
        const auto is_zero = hn::Eq(integers, hn::Zero(Ints()));
        const VF divisor = hn::ConvertTo(d, hn::IfThenElse(is_zero, hn::Set(Ints(), 1), integers));
        store_lanes(d, hn::Div(hn::Set(d, 1.0f), divisor), over_q.data(), lane);
    });
    const StoredPlane* const stored = run.record.planes();
    for (unsigned i = 0; i < source.coordinates(); ++i) {
        const unsigned plane = source.first + i;
        for_values<1>(run,
                      plane,
                      planes,
                      over_q.data(),
                      {divided_scale(stored[plane].scale(), stored[q].scale())},
                      [&](unsigned, VF value, std::size_t lane)
                          HWY_ATTR { store_lanes(d, value, out[i], lane); });
    }
}

template <unsigned Count>
void coordinate_runs(const TexCoordSource& source,
                     std::span<const BatchRun> runs,
                     const PerspectivePlanes& planes,
                     const FragmentBatch& batch,
                     const std::array<float*, 3>& out) {
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        if (source.divides(run.record)) return divided_run(run, source, planes, out);
        for_planes<Count>(
            run, source.first, planes, [&](unsigned i, VF value, std::size_t lane) HWY_ATTR {
                store_lanes(Floats(), value, out[i], lane);
            });
    });
}

void InterpolateTexCoords(const TexCoordSource& source,
                          std::span<const BatchRun> runs,
                          const PerspectivePlanes& planes,
                          const FragmentBatch& batch,
                          TexCoordPlanes& out) {
    const std::array<float*, 3> all = begin_coordinates(source, batch.lanes(), out);
    switch (source.coordinates()) {
    case 1:
        return coordinate_runs<1>(source, runs, planes, batch, all);
    case 2:
        return coordinate_runs<2>(source, runs, planes, batch, all);
    case 3:
        return coordinate_runs<3>(source, runs, planes, batch, all);
    default:
        return;
    }
}

void InterpolateDirections(const TexCoordSource& source,
                           std::span<const BatchRun> runs,
                           const PerspectivePlanes& planes,
                           const FragmentBatch& batch,
                           TexCoordPlanes& out) {
    const Floats d;
    const std::array<float*, 3> all = begin_coordinates(source, batch.lanes(), out);
    if (source.carried == 0) return;
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const std::array<float, 3> scales = direction_scales(run.record, source);
        for (unsigned i = 0; i < source.coordinates(); ++i) {
            const VF scale = hn::Set(d, scales[i]);
            for_integers_of(
                run, source.first + i, planes, [&](VI integers, std::size_t lane) HWY_ATTR {
                    const VF value = hn::Mul(hn::ConvertTo(d, integers), scale);
                    store_lanes(d, value, all[i], lane);
                });
        }
    });
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

namespace {

void check_coordinates(const TexCoordPlanes& planes, unsigned lanes) {
    check_ordinary({planes.s.data(), lanes});
    check_ordinary({planes.t.data(), lanes});
    check_ordinary({planes.r.data(), lanes});
}

} // namespace

HWY_EXPORT(InterpolateDepth);
HWY_EXPORT(InterpolateSampleDepths);
HWY_EXPORT(InterpolatePerspective);
HWY_EXPORT(InterpolateColors);
HWY_EXPORT(InterpolateTexCoords);
HWY_EXPORT(InterpolateDirections);

void interpolate_depth(std::span<const BatchRun> runs, FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(InterpolateDepth)(runs, batch);
}

void interpolate_sample_depths(std::span<const BatchRun> runs,
                               const FragmentBatch& batch,
                               SampleDepths& depths) {
    HWY_DYNAMIC_DISPATCH(InterpolateSampleDepths)(runs, batch, depths);
}

void interpolate_perspective(std::span<const BatchRun> runs,
                             const FragmentBatch& batch,
                             PerspectivePlanes& perspective) {
    HWY_DYNAMIC_DISPATCH(InterpolatePerspective)(runs, batch, perspective);
    check_ordinary({perspective.w.data(), batch.lanes()});
}

void interpolate_colors(const InterpolantLayout& layout,
                        std::span<const BatchRun> runs,
                        const PerspectivePlanes& perspective,
                        FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(InterpolateColors)(layout, runs, perspective, batch);
    if (layout.fog >= 0) check_ordinary({batch.fog_coordinate.data(), batch.lanes()});
}

void interpolate_tex_coords(const InterpolantLayout& layout,
                            unsigned unit,
                            std::span<const BatchRun> runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out) {
    HWY_DYNAMIC_DISPATCH(InterpolateTexCoords)
    (TexCoordSource(layout, unit), runs, perspective, batch, out);
    check_coordinates(out, batch.lanes());
}

void interpolate_directions(const InterpolantLayout& layout,
                            unsigned unit,
                            std::span<const BatchRun> runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out) {
    HWY_DYNAMIC_DISPATCH(InterpolateDirections)
    (TexCoordSource(layout, unit), runs, perspective, batch, out);
    check_coordinates(out, batch.lanes());
}

} // namespace ffgpu
#endif
