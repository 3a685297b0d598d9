// The specification of the interpolator, a fragment at a time.

#include "model/raster/interpolator.h"

#include "model/arith/range.h"
#include "model/arith/reciprocal.h"
#include "model/raster/sample_positions.h"

#include <algorithm>
#include <bit>

namespace ffgpu {
namespace {

struct Fragment {
    const SetupRecord& record;
    unsigned lane;
    int x, y; // relative to the record's reference pixel

    // The plane's integer: that of the quad's corner, and the lane's offset. In a lane that a piece
    // does not cover their sum may go round, as it does in registers.
    std::int32_t at(const AttributePlane& plane) const {
        const int right = static_cast<int>(lane & 1), up = static_cast<int>(lane >> 1 & 1);
        const auto corner = static_cast<std::uint32_t>(plane.corner(x - right, y - up));
        const auto offset = static_cast<std::uint32_t>(plane.lane_offsets()[lane % 4]);
        return static_cast<std::int32_t>(corner + offset);
    }
    // times w
    float value(unsigned i, float w) const {
        const AttributePlane plane = record.plane(i);
        return (static_cast<float>(at(plane)) * w) * plane.scale;
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
    return static_cast<std::uint16_t>(std::clamp(value, 0.0f, 255.0f) + 0.5f);
}

// q = 0 counts as the least number that q can be.
float reciprocal_of_q(std::int32_t q) {
    return reciprocal(static_cast<float>(q == 0 ? 1 : q));
}

int exponent_of(float power_of_two) {
    return static_cast<int>(std::bit_cast<std::uint32_t>(power_of_two) >> 23) - 127;
}

float power_of_two(int exponent) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(exponent + 127) << 23);
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

float divided_scale(float coordinate_scale, float q_scale) {
    return power_of_two(std::clamp(exponent_of(coordinate_scale) - exponent_of(q_scale), -58, 77));
}

std::array<float, 3> direction_scales(const SetupRecord& record, const TexCoordSource& source) {
    std::array<int, 3> exponents{-127, -127, -127};
    for (unsigned i = 0; i < source.coordinates(); ++i)
        exponents[i] = exponent_of(record.planes()[source.first + i].scale());
    const int greatest = *std::max_element(exponents.begin(), exponents.end());
    std::array<float, 3> scales{};
    for (unsigned i = 0; i < 3; ++i)
        scales[i] = power_of_two(std::max(exponents[i] - greatest, -32));
    return scales;
}

void interpolate_perspective_scalar(std::span<const BatchRun> runs,
                                    const FragmentBatch& batch,
                                    PerspectivePlanes& perspective) {
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        const SetupRecord& record = at.record;
        perspective.w[at.lane] =
            record.perspective ? reciprocal(static_cast<float>(
                                     std::max(at.at(record.inverse_w()), record.inverse_w_floor)))
                               : 1.0f;
    });
}

void interpolate_colors_scalar(const InterpolantLayout& layout,
                               std::span<const BatchRun> runs,
                               const PerspectivePlanes& perspective,
                               FragmentBatch& batch) {
    batch.full_channels = 0; // which is to know nothing
    const auto color = [&](const Fragment& at, int first, ColorPlanes& to, unsigned channels) {
        const std::array<std::uint16_t*, 4> planes{
            to.r.data(), to.g.data(), to.b.data(), to.a.data()};
        for (unsigned i = 0; i < channels; ++i)
            planes[i][at.lane] =
                color_value(at.value(static_cast<unsigned>(first) + i, perspective.w[at.lane]));
    };
    const auto constant = [](unsigned lane, const std::array<std::uint8_t, 4>& c, ColorPlanes& to) {
        to.r[lane] = c[0];
        to.g[lane] = c[1];
        to.b[lane] = c[2];
    };
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        const unsigned lane = at.lane;
        if (layout.color >= 0) {
            color(at, layout.color, batch.primary, 4);
            if (at.record.constant_color) {
                constant(lane, at.record.color, batch.primary);
                batch.primary.a[lane] = at.record.color[3];
            }
        }
        if (layout.secondary >= 0) {
            color(at, layout.secondary, batch.secondary, 3);
            batch.secondary.a[lane] = 0;
            if (at.record.constant_secondary) constant(lane, at.record.secondary, batch.secondary);
        }
        if (layout.fog >= 0)
            batch.fog_coordinate[lane] =
                in_fog_range(at.value(static_cast<unsigned>(layout.fog), perspective.w[lane]));
    });
}

void interpolate_tex_coords_scalar(const InterpolantLayout& layout,
                                   unsigned unit,
                                   std::span<const BatchRun> runs,
                                   const PerspectivePlanes& perspective,
                                   const FragmentBatch& batch,
                                   TexCoordPlanes& out) {
    const std::array<float*, 3> planes{out.s.data(), out.t.data(), out.r.data()};
    const TexCoordSource source(layout, unit);
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        const bool divides = source.divides(at.record);
        const AttributePlane q = divides ? at.record.plane(source.first + 3) : AttributePlane{};
        const float over_q = divides ? reciprocal_of_q(at.at(q)) : 0.0f;
        for (unsigned i = 0; i < 3; ++i) {
            float value = 0;
            if (i < source.carried) value = at.value(source.first + i, perspective.w[at.lane]);
            if (i < source.carried && divides) {
                const AttributePlane plane = at.record.plane(source.first + i);
                value = (static_cast<float>(at.at(plane)) * over_q) *
                        divided_scale(plane.scale, q.scale);
            }
            planes[i][at.lane] = value;
        }
    });
}

void interpolate_directions_scalar(const InterpolantLayout& layout,
                                   unsigned unit,
                                   std::span<const BatchRun> runs,
                                   const PerspectivePlanes& /*perspective*/,
                                   const FragmentBatch& batch,
                                   TexCoordPlanes& out) {
    const std::array<float*, 3> planes{out.s.data(), out.t.data(), out.r.data()};
    const TexCoordSource source(layout, unit);
    for_each_fragment(runs, batch, [&](const Fragment& at) {
        const std::array<float, 3> scales = direction_scales(at.record, source);
        for (unsigned i = 0; i < 3; ++i)
            planes[i][at.lane] =
                i < source.carried
                    ? static_cast<float>(at.at(at.record.plane(source.first + i))) * scales[i]
                    : 0.0f;
    });
}

} // namespace ffgpu
