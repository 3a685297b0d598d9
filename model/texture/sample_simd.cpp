// The vector stages in order, and around them what happens once a batch: the anisotropic probes,
// their mean, and the order of the accesses in the work stream.

#include "model/arith/range.h"
#include "model/texture/coordinates.h"
#include "model/texture/level_of_detail.h"
#include "model/texture/sampling_batch.h"
#include "model/texture/texture_unit.h"

#include <algorithm>
#include <array>
#include <vector>

namespace ffgpu {
namespace {

void fill_opaque_black(unsigned lanes, ColorPlanes& out) {
    std::fill_n(out.r.begin(), lanes, std::uint16_t{0});
    std::fill_n(out.g.begin(), lanes, std::uint16_t{0});
    std::fill_n(out.b.begin(), lanes, std::uint16_t{0});
    std::fill_n(out.a.begin(), lanes, std::uint16_t{255});
}

// One coordinate at probe i; quads that have fewer repeat their first.
void move_plane(const std::array<float, BatchFragments>& from,
                const std::array<float, BatchFragments>& step,
                const std::array<float, BatchFragments>& position,
                unsigned lanes,
                std::array<float, BatchFragments>& to) {
    for (unsigned lane = 0; lane < lanes; ++lane)
        to[lane] = move_to_probe(from[lane], step[lane], position[lane]);
}

void move_batch(const TextureUnit& unit,
                const TexCoordPlanes& from,
                const SamplingBatch& sampling,
                unsigned i,
                unsigned lanes,
                TexCoordPlanes& to) {
    alignas(64) std::array<float, BatchFragments> position;
    for (unsigned lane = 0; lane < lanes; ++lane) {
        const unsigned probes = sampling.probes[lane / 4];
        position[lane] = probe_position(i <= probes ? i : 1, probes);
    }
    const TexCoordPlanes& step = sampling.major_step;
    move_plane(from.s, step.s, position, lanes, to.s);
    if (unit.dimensions > 1) move_plane(from.t, step.t, position, lanes, to.t);
    if (unit.dimensions > 2) move_plane(from.r, step.r, position, lanes, to.r);
}

// Sums of the probes, and at the end their mean, in place.
struct ProbeMean {
    ColorPlanes sum{};

    void add(const ColorPlanes& color, const SamplingBatch& sampling, unsigned i, unsigned lanes) {
        for (unsigned lane = 0; lane < lanes; ++lane) {
            const auto counts = static_cast<std::uint16_t>(i <= sampling.probes[lane / 4] ? -1 : 0);
            sum.r[lane] = static_cast<std::uint16_t>(sum.r[lane] + (color.r[lane] & counts));
            sum.g[lane] = static_cast<std::uint16_t>(sum.g[lane] + (color.g[lane] & counts));
            sum.b[lane] = static_cast<std::uint16_t>(sum.b[lane] + (color.b[lane] & counts));
            sum.a[lane] = static_cast<std::uint16_t>(sum.a[lane] + (color.a[lane] & counts));
        }
    }
    void store(const SamplingBatch& sampling, unsigned lanes, ColorPlanes& out) const {
        for (unsigned lane = 0; lane < lanes; ++lane) {
            const unsigned n = sampling.probes[lane / 4];
            const auto mean = [n](unsigned total) {
                return static_cast<std::uint16_t>((total + n / 2) / n);
            };
            out.r[lane] = mean(sum.r[lane]);
            out.g[lane] = mean(sum.g[lane]);
            out.b[lane] = mean(sum.b[lane]);
            out.a[lane] = mean(sum.a[lane]);
        }
    }
};

// Where one probe's accesses are in memory: batch-sized, so kept apart from the usual case of one.
struct AccessLog {
    AccessBatch first;
    std::vector<AccessBatch> others;

    AccessBatch& probe(unsigned i) {
        if (i == 0) return first;
        if (others.size() < i) others.resize(i);
        return others[i - 1];
    }
};

// The accesses of one lane: probe after probe, of each the finer level first.
TexelAccess*
append_lane(const SamplingBatch& sampling, AccessLog& log, unsigned lane, TexelAccess* to) {
    const bool two_levels = (sampling.choice[lane] >> 16 & 0xff) != 0;
    const unsigned count = sampling.max_probes > 1 ? sampling.probes[lane / 4] : 1;
    for (unsigned i = 0; i < count; ++i) {
        const AccessBatch& accesses = log.probe(i);
        *to++ = accesses.level[lane];
        if (two_levels) *to++ = accesses.next_level[lane];
    }
    return to;
}

// Appends the live lanes' accesses in order. The vector is made as long as it can get, filled, and
// cut.
void append_accesses(const SamplingBatch& sampling,
                     AccessLog& log,
                     const FragmentMask& live,
                     unsigned quad_count,
                     std::vector<TexelAccess>& out) {
    const std::size_t begin = out.size();
    const unsigned levels = sampling.any_weight() ? 2 : 1;
    const bool one_each = levels == 1 && sampling.max_probes == 1;
    out.resize(begin + std::size_t{4} * quad_count * levels * sampling.max_probes);
    TexelAccess* to = out.data() + begin;
    for (unsigned quad = 0; quad < quad_count; ++quad) {
        const unsigned lanes = live.quad(quad);
        if (one_each && lanes == 0xf) {
            to = std::copy_n(log.first.level.data() + 4 * quad, 4, to);
            continue;
        }
        for (unsigned i = 0; i < 4; ++i)
            if (lanes >> i & 1) to = append_lane(sampling, log, 4 * quad + i, to);
    }
    out.resize(static_cast<std::size_t>(to - out.data()));
}

// One filter pass for each probe, and the mean of what they give.
void filter_probes(const TextureUnit& unit, FilterInputs inputs, ColorPlanes& out, AccessLog* log) {
    const SamplingBatch& sampling = *inputs.sampling;
    const unsigned lanes = 4 * grouped_quads(inputs.quad_count);
    ProbeMean mean;
    TexCoordPlanes moved;
    const TexCoordPlanes& middle = *inputs.coordinates;
    inputs.coordinates = &moved;
    for (unsigned i = 1; i <= sampling.max_probes; ++i) {
        move_batch(unit, middle, sampling, i, lanes, moved);
        filter_batch(unit, inputs, out);
        mean.add(out, sampling, i, lanes);
        if (log) record_batch(unit, inputs, log->probe(i - 1));
    }
    mean.store(sampling, lanes, out);
}

// Vectors hold whole groups: behind the last quad stands the last quad.
void fill_group(const TextureUnit& unit, unsigned quad_count, TexCoordPlanes& planes) {
    const auto fill = [&](std::array<float, BatchFragments>& plane) {
        for (unsigned lane = 4 * quad_count; lane < 4 * grouped_quads(quad_count); ++lane)
            plane[lane] = plane[lane - 4];
    };
    fill(planes.s);
    if (unit.dimensions > 1) fill(planes.t);
    if (unit.dimensions > 2 || unit.kind == TextureKind::Cube || unit.compares()) fill(planes.r);
}

// What the specification of the level of detail meets on its way.
void check_levels(const TextureUnit& unit, const TexCoordPlanes& planes, unsigned quad_count) {
    if constexpr (ChecksRanges)
        for (unsigned lane = 0; lane < 4 * quad_count; lane += 4) {
            const std::array<TexCoord, 4> lanes{coordinates_of(planes, lane),
                                                coordinates_of(planes, lane + 1),
                                                coordinates_of(planes, lane + 2),
                                                coordinates_of(planes, lane + 3)};
            const QuadSampling quad = sample_quad(unit, lanes, true);
            const float moved = move_to_probe(lanes[0].s, quad.major_step.s, probe_position(1, 16));
            const float numbers[] = {
                lanes[0].s, lanes[0].t, quad.major_step.s, quad.major_step.t, moved};
            check_ordinary(std::span(numbers).first(unit.dimensions > 1 ? 5 : 1));
        }
}

} // namespace

void sample(const TextureUnit& unit,
            TexCoordPlanes& coordinates,
            const SampleQuads& quads,
            ColorPlanes& out,
            TexelFootprints* footprints) {
    if (!unit.valid) return fill_opaque_black(4 * quads.count, out);
    if (quads.count == 0) return;
    // The wide filters have no vectors: they are there to be compared, not to be fast.
    if (!can_filter_batches() || unit.filter != TextureFilter::Standard)
        return sample_scalar(unit, coordinates, quads, out, footprints);

    fill_group(unit, quads.count, coordinates);
    ProjectedBatch projected;
    SamplingBatch sampling;
    const bool cube = unit.kind == TextureKind::Cube;
    if (cube) project_batch(coordinates, quads, projected);
    const LevelInputs level_inputs{cube ? &projected.level_of_detail : &coordinates,
                                   cube ? projected.one_face.data() : nullptr};
    choose_levels_batch(unit, level_inputs, quads.count, sampling);
    check_levels(unit, *level_inputs.coordinates, quads.count);

    const FilterInputs inputs{cube ? &projected.sample : &coordinates,
                              coordinates.r.data(),
                              projected.face.data(),
                              &sampling,
                              quads.count};
    AccessLog log;
    if (sampling.max_probes > 1) {
        filter_probes(unit, inputs, out, footprints ? &log : nullptr);
    } else {
        filter_batch(unit, inputs, out);
        if (footprints) record_batch(unit, inputs, log.first);
    }
    if (footprints) append_accesses(sampling, log, quads.live, quads.count, footprints->accesses);
}

} // namespace ffgpu
