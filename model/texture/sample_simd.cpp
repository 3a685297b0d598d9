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

// Of `live` those that have a probe `i`, counted from 0.
FragmentMask
probed_lanes(const SamplingBatch& sampling, unsigned i, unsigned quads, const FragmentMask& live) {
    FragmentMask mask = live;
    for (unsigned quad = 0; quad < quads; ++quad)
        if (i >= sampling.probes[quad])
            mask.words[quad / 16] &= ~(std::uint64_t{0xf} << 4 * (quad % 16));
    return mask;
}

// Appends what the batch's live lanes read in their probe `i`, of each the finer level first.
void append_accesses(const TextureUnit& unit,
                     const FilterInputs& inputs,
                     const FragmentMask& alive,
                     unsigned i,
                     std::pmr::vector<AccessPlane>& planes) {
    const SamplingBatch& sampling = *inputs.sampling;
    const unsigned quads = inputs.quad_count;
    FragmentMask live = alive;
    if (sampling.max_probes > 1) live = probed_lanes(sampling, i, quads, alive);
    if (!live.any()) return;
    FragmentMask blended;
    if (sampling.any_weight()) blended = weighted_lanes(sampling, quads) & live;
    const bool has_layers = unit.kind == TextureKind::Cube || unit.dimensions > 2;
    const std::size_t levels = blended.any() ? 2 : 1;
    planes.reserve(planes.size() + levels);
    const AccessPlane::Memory memory = planes.get_allocator().resource();
    AccessPlanes out;
    out.level = &planes.emplace_back(grouped_quads(quads), has_layers, memory);
    out.level->lanes = live;
    if (levels > 1) {
        out.next_level = &planes.emplace_back(grouped_quads(quads), has_layers, memory);
        out.next_level->lanes = blended;
    }
    record_batch(unit, inputs, out);
}

// One filter pass for each probe, and the mean of what they give.
void filter_probes(const TextureUnit& unit,
                   FilterInputs inputs,
                   const FragmentMask& live,
                   bool colors,
                   ColorPlanes& out,
                   TexelFootprints* footprints) {
    const SamplingBatch& sampling = *inputs.sampling;
    const unsigned lanes = 4 * grouped_quads(inputs.quad_count);
    ProbeMean mean;
    TexCoordPlanes moved;
    const TexCoordPlanes& middle = *inputs.coordinates;
    inputs.coordinates = &moved;
    for (unsigned i = 1; i <= sampling.max_probes; ++i) {
        move_batch(unit, middle, sampling, i, lanes, moved);
        if (colors) {
            filter_batch(unit, inputs, out);
            mean.add(out, sampling, i, lanes);
        }
        if (footprints) append_accesses(unit, inputs, live, i - 1, footprints->planes);
    }
    if (colors) mean.store(sampling, lanes, out);
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
    if (sampling.max_probes > 1) {
        filter_probes(unit, inputs, quads.live, quads.colors, out, footprints);
    } else {
        if (quads.colors) filter_batch(unit, inputs, out);
        if (footprints) append_accesses(unit, inputs, quads.live, 0, footprints->planes);
    }
}

} // namespace ffgpu
