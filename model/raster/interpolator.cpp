// The SIMD form of the interpolator: the same binary32 operations in the same order, on 4 to 16
// fragments at once.
//
// Runs go in ascending order and a vector may run over the end of its run: those lanes belong to
// the next run, which writes them afterwards, or to nobody.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/interpolator.cpp"

#include "model/raster/interpolator.h"
#include "model/raster/sample_positions.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using QuadFloats = hn::FixedTag<float, 4>;

// The lanes of one primitive. Its reference pixel relative to the tile's corner is made of whole
// numbers, so the additions that go from one to the other are exact.
struct LaneRun {
    const SetupRecord& record;
    std::size_t first, end;
    float x, y;
};

// Calls body(run) for each run of the batch.
template <class Body>
HWY_INLINE void for_runs(std::span<const BatchRun> runs, const FragmentBatch& batch, Body&& body) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const SetupRecord& record = *runs[i].record;
        const unsigned end = i + 1 < runs.size() ? runs[i + 1].first_quad : batch.quad_count;
        body(LaneRun{record,
                     std::size_t{4} * runs[i].first_quad,
                     std::size_t{4} * end,
                     static_cast<float>(batch.tile_x - record.x_reference),
                     static_cast<float>(batch.tile_y - record.y_reference)});
    }
}

// Calls body(d, lane) for vectors that cover the run and do not leave the batch.
template <class Body>
HWY_INLINE void for_lanes(const LaneRun& run, Body&& body) {
    const Floats d;
    std::size_t lane = run.first;
    for (; lane < run.end && lane + hn::Lanes(d) <= BatchFragments; lane += hn::Lanes(d))
        body(d, lane);
    for (; lane < run.end; lane += 4)
        body(QuadFloats(), lane);
}

template <class D>
HWY_INLINE hn::Vec<D> plane_at(D d, const AttributePlane& plane, hn::Vec<D> x, hn::Vec<D> y) {
    const auto along_x = hn::Add(hn::Set(d, plane.c), hn::Mul(hn::Set(d, plane.dx), x));
    return hn::Add(along_x, hn::Mul(hn::Set(d, plane.dy), y));
}

// Evaluates a run's planes for a vector of lanes.
template <class D>
struct LanePlanes {
    D d;
    const SetupRecord& record;
    hn::Vec<D> x, y, w;

    HWY_INLINE
    LanePlanes(D tag, const LaneRun& run, const PerspectivePlanes& planes, std::size_t lane)
        : d(tag)
        , record(run.record)
        , x(hn::Add(hn::LoadU(tag, planes.x.data() + lane), hn::Set(tag, run.x)))
        , y(hn::Add(hn::LoadU(tag, planes.y.data() + lane), hn::Set(tag, run.y)))
        , w(hn::LoadU(tag, planes.w.data() + lane)) {}

    HWY_INLINE hn::Vec<D> at(int i) const {
        return hn::Mul(plane_at(d, record.plane(static_cast<unsigned>(i)), x, y), w);
    }
};

template <class D>
HWY_INLINE void store_color(D d, hn::Vec<D> value, std::uint16_t* at) {
    const auto positive = hn::IfThenElseZero(hn::Gt(value, hn::Zero(d)), value);
    const auto clamped = hn::Min(positive, hn::Set(d, 1.0f));
    const auto scaled = hn::Add(hn::Mul(clamped, hn::Set(d, 255.0f)), hn::Set(d, 0.5f));
    const hn::RebindToSigned<D> integers;
    const hn::Rebind<std::uint16_t, D> halves;
    hn::StoreU(hn::DemoteTo(halves, hn::ConvertTo(integers, scaled)), halves, at);
}

void fill(std::uint16_t* plane, std::size_t first, std::size_t end, std::uint16_t value) {
    for (std::size_t lane = first; lane < end; ++lane)
        plane[lane] = value;
}

std::uint16_t constant_color(float value) {
    const float positive = value > 0 ? value : 0;
    return static_cast<std::uint16_t>((positive < 1.0f ? positive : 1.0f) * 255.0f + 0.5f);
}

// A colour whose planes stand at `first` in the layout.
void color_run(const LaneRun& run,
               int first,
               bool constant,
               const PerspectivePlanes& planes,
               std::span<std::uint16_t* const> out) {
    if (constant) {
        const float* const value = run.record.plane_c() + first;
        for (std::size_t i = 0; i < out.size(); ++i)
            fill(out[i], run.first, run.end, constant_color(value[i]));
        return;
    }
    for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
        const LanePlanes at(d, run, planes, lane);
        for (std::size_t i = 0; i < out.size(); ++i)
            store_color(d, at.at(first + static_cast<int>(i)), out[i] + lane);
    });
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

// Four quads at a time: each one's corner in all four lanes, and the lanes' own offsets.
void place_axis(const std::uint16_t* corner, int tile, const float* lane_offset, float* out) {
    const QuadFloats d;
    const hn::RebindToSigned<QuadFloats> integers;
    const hn::Rebind<std::uint16_t, QuadFloats> halves;
    const auto offset = hn::Load(d, lane_offset);
    const auto whole = hn::PromoteTo(integers, hn::LoadU(halves, corner));
    const auto at = hn::ConvertTo(d, hn::Sub(whole, hn::Set(integers, tile)));
    hn::Store(hn::Add(hn::Broadcast<0>(at), offset), d, out);
    hn::Store(hn::Add(hn::Broadcast<1>(at), offset), d, out + 4);
    hn::Store(hn::Add(hn::Broadcast<2>(at), offset), d, out + 8);
    hn::Store(hn::Add(hn::Broadcast<3>(at), offset), d, out + 12);
}

void place_fragments(const FragmentBatch& batch, PerspectivePlanes& planes) {
    alignas(16) static constexpr float LaneX[4] = {0, 1, 0, 1};
    alignas(16) static constexpr float LaneY[4] = {0, 0, 1, 1};
    for (std::size_t q = 0; q < batch.quad_count; q += 4) {
        place_axis(batch.x.data() + q, batch.tile_x, LaneX, planes.x.data() + 4 * q);
        place_axis(batch.y.data() + q, batch.tile_y, LaneY, planes.y.data() + 4 * q);
    }
}

void InterpolatePerspective(std::span<const BatchRun> runs,
                            const FragmentBatch& batch,
                            PerspectivePlanes& planes) {
    place_fragments(batch, planes);
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const SetupRecord& record = run.record;
        for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
            auto w = hn::Set(d, 1.0f);
            if (record.perspective) {
                const auto x = hn::Add(hn::LoadU(d, planes.x.data() + lane), hn::Set(d, run.x));
                const auto y = hn::Add(hn::LoadU(d, planes.y.data() + lane), hn::Set(d, run.y));
                const auto inverse = plane_at(d, record.inverse_w, x, y);
                const auto floor = hn::Set(d, record.inverse_w_floor);
                w = hn::Div(w, hn::IfThenElse(hn::Gt(inverse, floor), inverse, floor));
            }
            hn::StoreU(w, d, planes.w.data() + lane);
        });
    });
}

void InterpolateColors(const InterpolantLayout& layout,
                       std::span<const BatchRun> runs,
                       const PerspectivePlanes& planes,
                       FragmentBatch& batch) {
    ColorPlanes& one = batch.primary;
    ColorPlanes& two = batch.secondary;
    std::uint16_t* const primary[] = {one.r.data(), one.g.data(), one.b.data(), one.a.data()};
    std::uint16_t* const secondary[] = {two.r.data(), two.g.data(), two.b.data()};
    if (layout.secondary >= 0) fill(two.a.data(), 0, batch.lanes(), 0);
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const SetupRecord& record = run.record;
        if (layout.color >= 0) color_run(run, layout.color, record.constant_color, planes, primary);
        if (layout.secondary >= 0)
            color_run(run, layout.secondary, record.constant_secondary, planes, secondary);
        if (layout.fog >= 0)
            for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
                const LanePlanes at(d, run, planes, lane);
                hn::StoreU(at.at(layout.fog), d, batch.fog_coordinate.data() + lane);
            });
    });
}

void InterpolateTexCoords(const InterpolantLayout& layout,
                          unsigned unit,
                          std::span<const BatchRun> runs,
                          const PerspectivePlanes& planes,
                          const FragmentBatch& batch,
                          TexCoordPlanes& out) {
    float* const all[] = {out.s.data(), out.t.data(), out.r.data(), out.q.data()};
    const int first_plane = layout.tex_coord[unit];
    const unsigned carried = first_plane < 0 ? 0 : layout.tex_components[unit];
    for (unsigned i = carried; i < 4; ++i)
        for (std::size_t lane = 0; lane < batch.lanes(); ++lane)
            all[i][lane] = i == 3 ? 1.0f : 0.0f;
    if (carried == 0) return;
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
            const LanePlanes at(d, run, planes, lane);
            for (unsigned i = 0; i < carried; ++i)
                hn::StoreU(at.at(first_plane + static_cast<int>(i)), d, all[i] + lane);
        });
    });
}

} // namespace HWY_NAMESPACE
} // namespace ffgpu
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ffgpu {

HWY_EXPORT(InterpolateDepth);
HWY_EXPORT(InterpolateSampleDepths);
HWY_EXPORT(InterpolatePerspective);
HWY_EXPORT(InterpolateColors);
HWY_EXPORT(InterpolateTexCoords);

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
}

void interpolate_colors(const InterpolantLayout& layout,
                        std::span<const BatchRun> runs,
                        const PerspectivePlanes& perspective,
                        FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(InterpolateColors)(layout, runs, perspective, batch);
}

void interpolate_tex_coords(const InterpolantLayout& layout,
                            unsigned unit,
                            std::span<const BatchRun> runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out) {
    HWY_DYNAMIC_DISPATCH(InterpolateTexCoords)(layout, unit, runs, perspective, batch, out);
}

} // namespace ffgpu
#endif
