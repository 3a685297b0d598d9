#include "model/arith/reciprocal.h"
#include "model/raster/interpolator.h"
#include "model/raster/sample_positions.h"

#include <algorithm>

namespace ffgpu {
namespace {

struct Fragment {
    const SetupRecord& record;
    unsigned lane;
    int x, y; // relative to the record's reference pixel

    float plane(unsigned i) const {
        return record.plane(i).at(static_cast<float>(x), static_cast<float>(y));
    }
};

template <class Visit>
void for_each_fragment(std::span<const BatchRun> runs, const FragmentBatch& batch, Visit&& visit) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const SetupRecord& record = *runs[i].record;
        const unsigned end = i + 1 < runs.size() ? runs[i + 1].first_quad : batch.quad_count;
        for (unsigned lane = 4 * runs[i].first_quad; lane < 4 * end; ++lane) {
            const int x = batch.x[lane / 4] + static_cast<int>(lane & 1);
            const int y = batch.y[lane / 4] + static_cast<int>(lane >> 1 & 1);
            visit(Fragment{record, lane, x - record.x_reference, y - record.y_reference});
        }
    }
}

// At the point that lies `position` (1/256 pixel) beside the centre.
std::uint32_t depth_beside(const Fragment& at, SubPixelPoint position) {
    const DepthPlane& plane = at.record.depth;
    const auto half = std::int64_t{1} << (DepthPlane::FractionBits - 1);
    const auto sum = static_cast<std::uint64_t>(plane.at(at.x, at.y)) +
                     static_cast<std::uint64_t>(plane.beside(position) + half);
    const auto rounded = static_cast<std::int64_t>(sum) >> DepthPlane::FractionBits;
    return static_cast<std::uint32_t>(
        std::clamp<std::int64_t>(rounded, at.record.depth_min, at.record.depth_max));
}

std::uint16_t color_value(float value) {
    const float positive = value > 0 ? value : 0; // NaN is 0.
    return static_cast<std::uint16_t>(std::min(positive, 1.0f) * 255.0f + 0.5f);
}

} // namespace

bool needs_perspective(const InterpolantLayout& layout, std::span<const BatchRun> runs) {
    const unsigned colors = (layout.color < 0 ? 0u : 4u) + (layout.secondary < 0 ? 0u : 3u);
    if (layout.count > colors) return true;
    return std::any_of(runs.begin(), runs.end(), [&](const BatchRun& run) {
        return (layout.color >= 0 && !run.record->constant_color) ||
               (layout.secondary >= 0 && !run.record->constant_secondary);
    });
}

void interpolate_depth_scalar(std::span<const BatchRun> runs, FragmentBatch& batch) {
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        batch.depth[at.lane] = depth_beside(at, {0, 0});
    });
}

void interpolate_sample_depths_scalar(std::span<const BatchRun> runs,
                                      const FragmentBatch& batch,
                                      SampleDepths& depths) {
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        for (unsigned i = 0; i < MaxSamples; ++i)
            depths.of[i][at.lane] = depth_beside(at, SamplePositions[i]);
    });
}

void interpolate_perspective_scalar(std::span<const BatchRun> runs,
                                    const FragmentBatch& batch,
                                    PerspectivePlanes& perspective) {
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        float w = 1;
        if (at.record.perspective) {
            const float inverse =
                at.record.inverse_w.at(static_cast<float>(at.x), static_cast<float>(at.y));
            const float floor = at.record.inverse_w_floor;
            w = reciprocal(inverse > floor ? inverse : floor);
        }
        perspective.w[at.lane] = w;
    });
}

void interpolate_colors_scalar(const InterpolantLayout& layout,
                               std::span<const BatchRun> runs,
                               const PerspectivePlanes& perspective,
                               FragmentBatch& batch) {
    const auto color = [&](const Fragment& at, int first, unsigned channel, bool constant) {
        const unsigned i = static_cast<unsigned>(first) + channel;
        return color_value(constant ? at.record.plane_c()[i]
                                    : at.plane(i) * perspective.w[at.lane]);
    };
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        const unsigned lane = at.lane;
        if (layout.color >= 0) {
            const bool flat = at.record.constant_color;
            batch.primary.r[lane] = color(at, layout.color, 0, flat);
            batch.primary.g[lane] = color(at, layout.color, 1, flat);
            batch.primary.b[lane] = color(at, layout.color, 2, flat);
            batch.primary.a[lane] = color(at, layout.color, 3, flat);
        }
        if (layout.secondary >= 0) {
            const bool flat = at.record.constant_secondary;
            batch.secondary.r[lane] = color(at, layout.secondary, 0, flat);
            batch.secondary.g[lane] = color(at, layout.secondary, 1, flat);
            batch.secondary.b[lane] = color(at, layout.secondary, 2, flat);
            batch.secondary.a[lane] = 0;
        }
        if (layout.fog >= 0)
            batch.fog_coordinate[lane] =
                at.plane(static_cast<unsigned>(layout.fog)) * perspective.w[lane];
    });
}

void interpolate_tex_coords_scalar(const InterpolantLayout& layout,
                                   unsigned unit,
                                   std::span<const BatchRun> runs,
                                   const PerspectivePlanes& perspective,
                                   const FragmentBatch& batch,
                                   TexCoordPlanes& out) {
    const std::array<float*, 4> planes{out.s.data(), out.t.data(), out.r.data(), out.q.data()};
    const int first = layout.tex_coord[unit];
    const unsigned carried = first < 0 ? 0 : layout.tex_components[unit];
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        for (unsigned i = 0; i < 4; ++i)
            planes[i][at.lane] =
                i < carried ? at.plane(static_cast<unsigned>(first) + i) * perspective.w[at.lane]
                            : (i == 3 ? 1.0f : 0.0f);
    });
}

} // namespace ffgpu
