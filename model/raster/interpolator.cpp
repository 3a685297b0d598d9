// The SIMD form of the interpolator: the same binary32 operations in the same order, on 4 to 16
// fragments at once.
//
// Runs go in ascending order and a vector may run over the end of its run: those lanes belong to
// the next run, which writes them afterwards, or to nobody.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/interpolator.cpp"

#include "model/raster/interpolator.h"

#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ffgpu {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, 16>;
using QuadFloats = hn::FixedTag<float, 4>;

// Calls body(d, lane) for vectors that cover lanes first .. end - 1 and do not leave the batch.
template <class Body>
HWY_INLINE void for_lanes(std::size_t first, std::size_t end, Body&& body) {
    const Floats d;
    std::size_t lane = first;
    for (; lane < end && lane + hn::Lanes(d) <= BatchFragments; lane += hn::Lanes(d))
        body(d, lane);
    for (; lane < end; lane += 4)
        body(QuadFloats(), lane);
}

// Calls body(record, first lane, end lane) for each run.
template <class Body>
HWY_INLINE void for_runs(std::span<const BatchRun> runs, const FragmentBatch& batch, Body&& body) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const unsigned end = i + 1 < runs.size() ? runs[i + 1].first_quad : batch.quad_count;
        body(*runs[i].record, std::size_t{4} * runs[i].first_quad, std::size_t{4} * end);
    }
}

// Pixels relative to a record's reference pixel; integers, so exact.
struct RunOrigin {
    float x, y;

    RunOrigin(const SetupRecord& record, const FragmentBatch& batch)
        : x(static_cast<float>(batch.tile_x - record.x_reference))
        , y(static_cast<float>(batch.tile_y - record.y_reference)) {}
};

template <class D>
HWY_INLINE hn::Vec<D> plane_at(D d, const AttributePlane& plane, hn::Vec<D> x, hn::Vec<D> y) {
    const auto along_x = hn::Add(hn::Set(d, plane.c), hn::Mul(hn::Set(d, plane.dx), x));
    return hn::Add(along_x, hn::Mul(hn::Set(d, plane.dy), y));
}

// Evaluates a record's planes for a vector of lanes.
template <class D>
struct LanePlanes {
    D d;
    const SetupRecord& record;
    hn::Vec<D> x, y, w;

    HWY_INLINE LanePlanes(D tag,
                          const SetupRecord& r,
                          const RunOrigin& origin,
                          const PerspectivePlanes& planes,
                          std::size_t lane)
        : d(tag)
        , record(r)
        , x(hn::Add(hn::LoadU(tag, planes.x.data() + lane), hn::Set(tag, origin.x)))
        , y(hn::Add(hn::LoadU(tag, planes.y.data() + lane), hn::Set(tag, origin.y)))
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

// The first `channels` planes of a colour at `first` in the layout.
void color_run(const SetupRecord& record,
               int first,
               bool constant,
               const PerspectivePlanes& planes,
               const RunOrigin& origin,
               std::size_t begin,
               std::size_t end,
               std::span<std::uint16_t* const> out) {
    if (constant) {
        for (std::size_t i = 0; i < out.size(); ++i)
            fill(out[i],
                 begin,
                 end,
                 constant_color(record.plane_c()[static_cast<std::size_t>(first) + i]));
        return;
    }
    for_lanes(begin, end, [&](auto d, std::size_t lane) HWY_ATTR {
        const LanePlanes at(d, record, origin, planes, lane);
        for (std::size_t i = 0; i < out.size(); ++i)
            store_color(d, at.at(first + static_cast<int>(i)), out[i] + lane);
    });
}

void InterpolateDepth(std::span<const BatchRun> runs, FragmentBatch& batch) {
    const hn::CappedTag<std::int64_t, 4> d;
    const hn::RebindToUnsigned<decltype(d)> wide;
    const hn::Rebind<std::uint32_t, decltype(d)> narrow;
    constexpr auto Half = std::int64_t{1} << (DepthPlane::FractionBits - 1);
    for_runs(
        runs, batch, [&](const SetupRecord& record, std::size_t first, std::size_t end) HWY_ATTR {
            const DepthPlane& plane = record.depth;
            alignas(32) const std::int64_t offsets[4] = {
                Half, Half + plane.dx, Half + plane.dy, Half + plane.dx + plane.dy};
            const auto lowest = hn::Set(d, std::int64_t{record.depth_min});
            const auto highest = hn::Set(d, std::int64_t{record.depth_max});
            for (std::size_t lane = first; lane < end; lane += 4) {
                const auto base = hn::Set(d,
                                          plane.at(batch.x[lane / 4] - record.x_reference,
                                                   batch.y[lane / 4] - record.y_reference));
                for (std::size_t i = 0; i < 4; i += hn::Lanes(d)) {
                    const auto sum = hn::Add(base, hn::Load(d, offsets + i));
                    const auto depth = hn::ShiftRight<DepthPlane::FractionBits>(sum);
                    const auto clamped = hn::Min(hn::Max(depth, lowest), highest);
                    hn::StoreU(hn::TruncateTo(narrow, hn::BitCast(wide, clamped)),
                               narrow,
                               batch.depth.data() + lane + i);
                }
            }
        });
}

void InterpolatePerspective(std::span<const BatchRun> runs,
                            const FragmentBatch& batch,
                            PerspectivePlanes& planes) {
    const QuadFloats quad;
    alignas(16) static constexpr float LaneX[4] = {0, 1, 0, 1}, LaneY[4] = {0, 0, 1, 1};
    for (std::size_t q = 0; q < batch.quad_count; ++q) {
        const auto x = hn::Set(quad, static_cast<float>(batch.x[q] - batch.tile_x));
        const auto y = hn::Set(quad, static_cast<float>(batch.y[q] - batch.tile_y));
        hn::Store(hn::Add(x, hn::Load(quad, LaneX)), quad, planes.x.data() + 4 * q);
        hn::Store(hn::Add(y, hn::Load(quad, LaneY)), quad, planes.y.data() + 4 * q);
    }
    for_runs(
        runs, batch, [&](const SetupRecord& record, std::size_t first, std::size_t end) HWY_ATTR {
            const RunOrigin origin(record, batch);
            for_lanes(first, end, [&](auto d, std::size_t lane) HWY_ATTR {
                auto w = hn::Set(d, 1.0f);
                if (record.perspective) {
                    const auto x =
                        hn::Add(hn::LoadU(d, planes.x.data() + lane), hn::Set(d, origin.x));
                    const auto y =
                        hn::Add(hn::LoadU(d, planes.y.data() + lane), hn::Set(d, origin.y));
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
    ColorPlanes& primary = batch.primary;
    ColorPlanes& secondary = batch.secondary;
    std::uint16_t* const all[] = {primary.r.data(),
                                  primary.g.data(),
                                  primary.b.data(),
                                  primary.a.data(),
                                  secondary.r.data(),
                                  secondary.g.data(),
                                  secondary.b.data(),
                                  secondary.a.data()};
    const std::span<std::uint16_t* const> every(all);
    const std::size_t lanes = batch.lanes();
    // What the layout does not carry.
    for (std::size_t i = layout.color < 0 ? 0 : 4; i < (layout.secondary < 0 ? 7u : 4u); ++i)
        fill(all[i], 0, lanes, 0);
    fill(all[7], 0, lanes, 0);
    if (layout.fog < 0)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            batch.fog_coordinate[lane] = 0;

    for_runs(
        runs, batch, [&](const SetupRecord& record, std::size_t first, std::size_t end) HWY_ATTR {
            const RunOrigin origin(record, batch);
            if (layout.color >= 0)
                color_run(record,
                          layout.color,
                          record.constant_color,
                          planes,
                          origin,
                          first,
                          end,
                          every.first(4));
            if (layout.secondary >= 0)
                color_run(record,
                          layout.secondary,
                          record.constant_secondary,
                          planes,
                          origin,
                          first,
                          end,
                          every.subspan(4, 3));
            if (layout.fog >= 0)
                for_lanes(first, end, [&](auto d, std::size_t lane) HWY_ATTR {
                    const LanePlanes at(d, record, origin, planes, lane);
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
    for_runs(
        runs, batch, [&](const SetupRecord& record, std::size_t first, std::size_t end) HWY_ATTR {
            const RunOrigin origin(record, batch);
            for_lanes(first, end, [&](auto d, std::size_t lane) HWY_ATTR {
                const LanePlanes at(d, record, origin, planes, lane);
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
HWY_EXPORT(InterpolatePerspective);
HWY_EXPORT(InterpolateColors);
HWY_EXPORT(InterpolateTexCoords);

void interpolate_depth(std::span<const BatchRun> runs, FragmentBatch& batch) {
    HWY_DYNAMIC_DISPATCH(InterpolateDepth)(runs, batch);
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
