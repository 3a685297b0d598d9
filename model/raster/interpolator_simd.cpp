// The fast form of the interpolator: as many fragments at once as a vector has lanes.
//
// Runs go in ascending order and a vector may run over the end of its run: those lanes belong to
// the next run, which writes them afterwards, or to nobody.

#include "model/base/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/interpolator_simd.cpp"

#include "model/arith/range.h"
#include "model/raster/interpolator.h"
#include "model/raster/sample_positions.h"

#include <algorithm>
#include <array>
#include <bit>

#include <hwy/foreach_target.h>
#include <hwy/highway.h>
// clang-format off: after foreach_target.h
#include "model/raster/color_lanes-inl.h"
#include "model/raster/depth_lanes-inl.h"
#include "model/raster/plane_lanes-inl.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

HWY_INLINE void depth_beside(SubPixelPoint position,
                             std::span<const BatchRun> runs,
                             const FragmentBatch& batch,
                             std::uint32_t* out) {
    for_runs(runs, batch.quad_count, [&](const LaneRun& run) HWY_ATTR {
        depth_run(position, run, batch, out);
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
    place_quads(batch, planes);
    for_runs(runs, batch.quad_count, [&](const LaneRun& run) HWY_ATTR {
        const SetupRecord& record = run.record;
        if (!record.perspective) {
            std::fill(planes.w.begin() + run.first, planes.w.begin() + run.end, 1.0f);
            return;
        }
        for_integers_of(
            run, record.plane_count, planes, [&](auto integers, std::size_t lane) HWY_ATTR {
                const hn::DFromV<decltype(integers)> ints;
                const hn::RebindToFloat<decltype(ints)> d;
                const auto floor = hn::Set(ints, record.inverse_w_floor);
                const auto inverse = hn::ConvertTo(d, hn::Max(integers, floor));
                store_lanes(d, hn::Div(hn::Set(d, 1.0f), inverse), planes.w.data(), lane);
            });
    });
}

template <class V>
HWY_INLINE V in_fog_range_lanes(V value) {
    const hn::DFromV<V> d;
    const auto large = hn::Min(hn::Max(value, hn::Set(d, -LargestFog)), hn::Set(d, LargestFog));
    return hn::IfThenElseZero(hn::Ge(hn::Abs(value), hn::Set(d, LeastFog)), large);
}

std::uint8_t full_channels(std::span<const BatchRun> runs) {
    std::uint32_t all = ~0u; // A channel is 255 in it where it is in each run.
    for (const BatchRun& run : runs)
        all &= run.record->constant_color ? std::bit_cast<std::uint32_t>(run.record->color) : 0;
    unsigned full = 0;
    for (unsigned i = 0; i < 4; ++i)
        full |= unsigned{(all >> 8 * i & 255) == 255} << i;
    return static_cast<std::uint8_t>(full);
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
    batch.full_channels = layout.color < 0 ? std::uint8_t{0} : full_channels(runs);
    if (layout.secondary >= 0) std::fill_n(two.a.begin(), batch.lanes(), std::uint16_t{0});
    for_runs(runs, batch.quad_count, [&](const LaneRun& run) HWY_ATTR {
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
                          [&](unsigned, auto value, std::size_t lane) HWY_ATTR {
                              store_lanes(hn::DFromV<decltype(value)>(),
                                          in_fog_range_lanes(value),
                                          batch.fog_coordinate.data(),
                                          lane);
                          });
    });
}

void InterpolateColorWords(unsigned first,
                           std::span<const BatchRun> runs,
                           unsigned lanes,
                           const PerspectivePlanes& planes,
                           std::uint32_t* words) {
    for_runs(runs, lanes / 4, [&](const LaneRun& run) HWY_ATTR {
        if (run.record.constant_color)
            fill_run(run, words, std::bit_cast<std::uint32_t>(run.record.color));
        else
            color_words_run(run, first, planes, words);
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
    alignas(64) std::array<float, PerspectivePlanes::PaddedLanes> over_q;
    const unsigned q = source.first + 3;
    for_integers_of(run, q, planes, [&](auto integers, std::size_t lane) HWY_ATTR {
        const hn::DFromV<decltype(integers)> ints;
        const hn::RebindToFloat<decltype(ints)> d;
        const auto is_zero = hn::Eq(integers, hn::Zero(ints));
        const auto divisor = hn::ConvertTo(d, hn::IfThenElse(is_zero, hn::Set(ints, 1), integers));
        store_lanes(d, hn::Div(hn::Set(d, 1.0f), divisor), over_q.data(), lane);
    });
    const StoredPlane* const stored = run.record.planes();
    for (unsigned i = 0; i < source.coordinates(); ++i) {
        const unsigned plane = source.first + i;
        const float scale = divided_scale(stored[plane].scale(), stored[q].scale());
        for_products<1>(run,
                        plane,
                        planes,
                        over_q.data(),
                        [&](unsigned, auto product, std::size_t lane) HWY_ATTR {
                            const hn::DFromV<decltype(product)> d;
                            store_lanes(d, hn::Mul(product, hn::Set(d, scale)), out[i], lane);
                        });
    }
}

template <unsigned Count>
void coordinate_runs(const TexCoordSource& source,
                     std::span<const BatchRun> runs,
                     const PerspectivePlanes& planes,
                     const FragmentBatch& batch,
                     const std::array<float*, 3>& out) {
    for_runs(runs, batch.quad_count, [&](const LaneRun& run) HWY_ATTR {
        if (source.divides(run.record)) return divided_run(run, source, planes, out);
        for_planes<Count>(
            run, source.first, planes, [&](unsigned i, auto value, std::size_t lane) HWY_ATTR {
                store_lanes(hn::DFromV<decltype(value)>(), value, out[i], lane);
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
    const std::array<float*, 3> all = begin_coordinates(source, batch.lanes(), out);
    if (source.carried == 0) return;
    for_runs(runs, batch.quad_count, [&](const LaneRun& run) HWY_ATTR {
        const std::array<float, 3> scales = direction_scales(run.record, source);
        for (unsigned i = 0; i < source.coordinates(); ++i) {
            for_integers_of(
                run, source.first + i, planes, [&](auto integers, std::size_t lane) HWY_ATTR {
                    const hn::RebindToFloat<hn::DFromV<decltype(integers)>> d;
                    const auto value = hn::Mul(hn::ConvertTo(d, integers), hn::Set(d, scales[i]));
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
HWY_EXPORT(InterpolateColorWords);
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

void interpolate_color_words(const InterpolantLayout& layout,
                             std::span<const BatchRun> runs,
                             const PerspectivePlanes& perspective,
                             unsigned lanes,
                             std::span<std::uint32_t, BatchFragments> words) {
    HWY_DYNAMIC_DISPATCH(InterpolateColorWords)
    (static_cast<unsigned>(layout.color), runs, lanes, perspective, words.data());
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
