// The fast form of the interpolator: the corners of a run's quads, a lane a quad, then 4 to 16
// fragments at once. Corners are computed modulo 2^32 in two parts of the plane, above and below
// its guard bits, which is exact as the true value fits.
//
// Runs go in ascending order and a vector may run over the end of its run: those lanes belong to
// the next run, which writes them afterwards, or to nobody.

#include "model/raster/simd_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "model/raster/interpolator_simd.cpp"

#include "model/arith/range.h"
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

// The lanes of one primitive, and the tile's corner relative to its reference pixel.
struct LaneRun {
    const SetupRecord& record;
    std::size_t first, end;
    int x, y;
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
                     batch.tile_x - record.x_reference,
                     batch.tile_y - record.y_reference});
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

constexpr std::array<std::uint8_t, 64> make_spread() {
    std::array<std::uint8_t, 64> bytes{};
    for (unsigned i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(4 * (i / 16) + i % 4);
    return bytes;
}
// Each quad's number to its four lanes.
alignas(64) constexpr std::array<std::uint8_t, 64> Spread = make_spread();

// A plane over one run.
class RunPlane {
public:
    HWY_INLINE
    RunPlane(const AttributePlane& plane, const LaneRun& run, const PerspectivePlanes& at)
        : scale(plane.scale)
        , offsets_(plane.lane_offsets()) {
        constexpr int Bits = AttributePlane::GuardBits;
        constexpr std::int64_t Low = (std::int64_t{1} << Bits) - 1;
        const hn::CappedTag<std::int32_t, 8> d;
        const auto high = [&](std::int64_t x)
                              HWY_ATTR { return hn::Set(d, static_cast<std::int32_t>(x >> Bits)); };
        const auto low = [&](std::int64_t x)
                             HWY_ATTR { return hn::Set(d, static_cast<std::int32_t>(x & Low)); };
        const std::int64_t c = plane.c + plane.dx * run.x + plane.dy * run.y + AttributePlane::Half;
        const auto c_high = high(c), dx_high = high(plane.dx), dy_high = high(plane.dy);
        const auto c_low = low(c), dx_low = low(plane.dx), dy_low = low(plane.dy);
        for (std::size_t quad = run.first / 4; quad < run.end / 4; quad += hn::Lanes(d)) {
            const auto x = hn::LoadU(d, at.x.data() + quad), y = hn::LoadU(d, at.y.data() + quad);
            const auto carried = hn::ShiftRight<Bits>(
                hn::Add(hn::Add(hn::Mul(dx_low, x), hn::Mul(dy_low, y)), c_low));
            const auto whole = hn::Add(hn::Mul(dx_high, x), hn::Mul(dy_high, y));
            hn::StoreU(hn::Add(hn::Add(whole, c_high), carried), d, corners_.data() + quad);
        }
    }

    // The integers of the lanes from `lane` on.
    template <class D>
    HWY_INLINE hn::Vec<hn::RebindToSigned<D>> integers(D, std::size_t lane) const {
        const hn::RebindToSigned<D> d;
        const hn::Repartition<std::uint8_t, D> bytes;
        const auto corners = hn::LoadDup128(d, corners_.data() + lane / 4);
        const auto spread = hn::TableLookupBytes(corners, hn::Load(bytes, Spread.data()));
        return hn::Add(hn::BitCast(d, spread), hn::LoadDup128(d, offsets_.data()));
    }

    // times w and `by`, a power of two
    template <class D>
    HWY_INLINE hn::Vec<D> values(D d, std::size_t lane, hn::Vec<D> w, float by) const {
        const auto value = hn::ConvertTo(d, integers(d, lane));
        return hn::Mul(hn::Mul(value, w), hn::Set(d, by));
    }

    const float scale;

private:
    alignas(16) std::array<std::int32_t, 4> offsets_;
    alignas(64) std::array<std::int32_t, PerspectivePlanes::Padded> corners_;
};

template <class D>
HWY_INLINE void store_color(D d, hn::Vec<D> value, std::uint16_t* at) {
    const auto clamped = hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 255.0f));
    const hn::RebindToSigned<D> integers;
    const hn::Rebind<std::uint16_t, D> halves;
    const auto rounded = hn::ConvertTo(integers, hn::Add(clamped, hn::Set(d, 0.5f)));
    hn::StoreU(hn::DemoteTo(halves, rounded), halves, at);
}

void fill(std::uint16_t* plane, std::size_t first, std::size_t end, std::uint16_t value) {
    for (std::size_t lane = first; lane < end; ++lane)
        plane[lane] = value;
}

// Planes `first` and on of the run's record, one for each of `out`, times w.
template <class Store>
HWY_INLINE void for_planes(const LaneRun& run,
                           unsigned first,
                           unsigned count,
                           const PerspectivePlanes& planes,
                           Store&& store) {
    for (unsigned i = 0; i < count; ++i) {
        const RunPlane plane(run.record.plane(first + i), run, planes);
        for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
            const auto w = hn::LoadU(d, planes.w.data() + lane);
            store(d, plane.values(d, lane, w, plane.scale), i, lane);
        });
    }
}

// A colour whose planes stand at `first` in the layout.
void color_run(const LaneRun& run,
               int first,
               const std::uint8_t* constant,
               const PerspectivePlanes& planes,
               std::span<std::uint16_t* const> out) {
    if (constant) {
        for (std::size_t i = 0; i < out.size(); ++i)
            fill(out[i], run.first, run.end, constant[i]);
        return;
    }
    for_planes(run,
               static_cast<unsigned>(first),
               static_cast<unsigned>(out.size()),
               planes,
               [&](auto d, auto value, unsigned i, std::size_t lane)
                   HWY_ATTR { store_color(d, value, out[i] + lane); });
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
    for (std::size_t q = 0; q < BatchQuads; ++q) {
        planes.x[q] = batch.x[q] - batch.tile_x;
        planes.y[q] = batch.y[q] - batch.tile_y;
    }
}

void InterpolatePerspective(std::span<const BatchRun> runs,
                            const FragmentBatch& batch,
                            PerspectivePlanes& planes) {
    place_quads(batch, planes);
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const SetupRecord& record = run.record;
        if (!record.perspective) {
            for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
                hn::StoreU(hn::Set(d, 1.0f), d, planes.w.data() + lane);
            });
            return;
        }
        const RunPlane plane(record.inverse_w, run, planes);
        for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
            const hn::RebindToSigned<decltype(d)> integers;
            const auto floor = hn::Set(integers, record.inverse_w_floor);
            const auto inverse = hn::ConvertTo(d, hn::Max(plane.integers(d, lane), floor));
            hn::StoreU(hn::Div(hn::Set(d, 1.0f), inverse), d, planes.w.data() + lane);
        });
    });
}

template <class D>
HWY_INLINE hn::Vec<D> in_fog_range_lanes(D d, hn::Vec<D> value) {
    const auto large = hn::Min(hn::Max(value, hn::Set(d, -LargestFog)), hn::Set(d, LargestFog));
    return hn::IfThenElseZero(hn::Ge(hn::Abs(value), hn::Set(d, LeastFog)), large);
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
        const auto constant = [](bool is, const std::array<std::uint8_t, 4>& color) {
            return is ? color.data() : nullptr;
        };
        if (layout.color >= 0)
            color_run(
                run, layout.color, constant(record.constant_color, record.color), planes, primary);
        if (layout.secondary >= 0)
            color_run(run,
                      layout.secondary,
                      constant(record.constant_secondary, record.secondary),
                      planes,
                      secondary);
        if (layout.fog >= 0)
            for_planes(run,
                       static_cast<unsigned>(layout.fog),
                       1,
                       planes,
                       [&](auto d, auto value, unsigned, std::size_t lane) HWY_ATTR {
                           hn::StoreU(
                               in_fog_range_lanes(d, value), d, batch.fog_coordinate.data() + lane);
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
    alignas(64) std::array<float, BatchFragments> over_q;
    const RunPlane q(run.record.plane(source.first + 3), run, planes);
    for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
        const auto integers = q.integers(d, lane);
        const hn::RebindToSigned<decltype(d)> di;
        const auto least = hn::IfThenElse(hn::Eq(integers, hn::Zero(di)), hn::Set(di, 1), integers);
        const auto divisor = hn::ConvertTo(d, least);
        hn::StoreU(hn::Div(hn::Set(d, 1.0f), divisor), d, over_q.data() + lane);
    });
    for (unsigned i = 0; i < source.coordinates(); ++i) {
        const RunPlane plane(run.record.plane(source.first + i), run, planes);
        const float scale = divided_scale(plane.scale, q.scale);
        for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
            const auto by = hn::LoadU(d, over_q.data() + lane);
            hn::StoreU(plane.values(d, lane, by, scale), d, out[i] + lane);
        });
    }
}

void InterpolateTexCoords(const TexCoordSource& source,
                          std::span<const BatchRun> runs,
                          const PerspectivePlanes& planes,
                          const FragmentBatch& batch,
                          TexCoordPlanes& out) {
    const std::array<float*, 3> all = begin_coordinates(source, batch.lanes(), out);
    if (source.carried == 0) return;
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        if (source.divides(run.record)) return divided_run(run, source, planes, all);
        for_planes(run,
                   source.first,
                   source.coordinates(),
                   planes,
                   [&](auto d, auto value, unsigned i, std::size_t lane)
                       HWY_ATTR { hn::StoreU(value, d, all[i] + lane); });
    });
}

void InterpolateDirections(const TexCoordSource& source,
                           std::span<const BatchRun> runs,
                           const PerspectivePlanes& planes,
                           const FragmentBatch& batch,
                           TexCoordPlanes& out) {
    const std::array<float*, 3> all = begin_coordinates(source, batch.lanes(), out);
    if (source.carried == 0) return;
    for_runs(runs, batch, [&](const LaneRun& run) HWY_ATTR {
        const std::array<float, 3> scales = direction_scales(run.record, source);
        for (unsigned i = 0; i < source.coordinates(); ++i) {
            const RunPlane plane(run.record.plane(source.first + i), run, planes);
            for_lanes(run, [&](auto d, std::size_t lane) HWY_ATTR {
                const auto value = hn::ConvertTo(d, plane.integers(d, lane));
                hn::StoreU(hn::Mul(value, hn::Set(d, scales[i])), d, all[i] + lane);
            });
        }
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
    HWY_DYNAMIC_DISPATCH(InterpolateTexCoords)
    (TexCoordSource(layout, unit), runs, perspective, batch, out);
}

void interpolate_directions(const InterpolantLayout& layout,
                            unsigned unit,
                            std::span<const BatchRun> runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out) {
    HWY_DYNAMIC_DISPATCH(InterpolateDirections)
    (TexCoordSource(layout, unit), runs, perspective, batch, out);
}

} // namespace ffgpu
#endif
