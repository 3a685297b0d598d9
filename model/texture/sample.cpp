// The vector stages in order, and around them what happens once a batch: the anisotropic probes,
// their mean, and the order of the accesses in the work stream.

#include "model/texture/coordinates.h"
#include "model/texture/sampling_batch.h"
#include "model/texture/texture_unit.h"

#include <algorithm>
#include <vector>

namespace ffgpu {
namespace {

void fill_opaque_black(unsigned lanes, ColorPlanes& out) {
    std::fill_n(out.r.begin(), lanes, std::uint16_t{0});
    std::fill_n(out.g.begin(), lanes, std::uint16_t{0});
    std::fill_n(out.b.begin(), lanes, std::uint16_t{0});
    std::fill_n(out.a.begin(), lanes, std::uint16_t{255});
}

// Quads that have fewer than i probes repeat their first.
void move_batch(const CoordinatePlanes& from,
                const SamplingBatch& sampling,
                unsigned i,
                unsigned lanes,
                CoordinatePlanes& to) {
    const CoordinatePlanes& step = sampling.major_step;
    for (unsigned lane = 0; lane < lanes; ++lane) {
        const unsigned probes = sampling.probes[lane / 4];
        const float at = probe_position(i <= probes ? i : 1, probes);
        to.s[lane] = move_to_probe(from.s[lane], step.s[lane], at);
        to.t[lane] = move_to_probe(from.t[lane], step.t[lane], at);
        to.r[lane] = move_to_probe(from.r[lane], step.r[lane], at);
    }
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

// Appends the live lanes' accesses: lane after lane, of a lane probe after probe, the finer level
// first.
void append_accesses(const SamplingBatch& sampling,
                     const std::vector<AccessBatch>& probes,
                     const FragmentMask& live,
                     unsigned quad_count,
                     std::vector<TexelAccess>& out) {
    out.reserve(out.size() + 8u * quad_count * probes.size());
    for (unsigned lane = 0; lane < 4 * quad_count; ++lane) {
        if (!live.test(lane)) continue;
        const bool two_levels = (sampling.choice[lane] >> 16 & 0xff) != 0;
        const unsigned count = sampling.max_probes > 1 ? sampling.probes[lane / 4] : 1;
        for (unsigned i = 0; i < count; ++i) {
            out.push_back(probes[i].level[lane]);
            if (two_levels) out.push_back(probes[i].next_level[lane]);
        }
    }
}

} // namespace

void sample(const TextureUnit& unit,
            const TexCoordPlanes& coordinates,
            unsigned quad_count,
            const FragmentMask& live,
            ColorPlanes& out,
            TexelFootprints* footprints) {
    const unsigned lanes = 4 * quad_count;
    if (!unit.valid) return fill_opaque_black(lanes, out);
    if (quad_count == 0) return;
    if (!can_filter_batches())
        return sample_reference(unit, coordinates, quad_count, live, out, footprints);

    ProjectedBatch projected;
    SamplingBatch sampling;
    project_batch(unit, coordinates, quad_count, projected);
    choose_levels_batch(unit, projected, quad_count, sampling);

    FilterInputs inputs{
        &projected.sample, projected.sample.r.data(), projected.face.data(), &sampling, quad_count};
    std::vector<AccessBatch> accesses(footprints ? sampling.max_probes : 0);
    if (sampling.max_probes == 1) {
        filter_batch(unit, inputs, out);
        if (footprints) record_batch(unit, inputs, accesses[0]);
    } else {
        ProbeMean mean;
        CoordinatePlanes moved;
        inputs.coordinates = &moved;
        for (unsigned i = 1; i <= sampling.max_probes; ++i) {
            move_batch(projected.sample, sampling, i, 4 * grouped_quads(quad_count), moved);
            filter_batch(unit, inputs, out);
            mean.add(out, sampling, i, lanes);
            if (footprints) record_batch(unit, inputs, accesses[i - 1]);
        }
        mean.store(sampling, lanes, out);
    }
    if (footprints) append_accesses(sampling, accesses, live, quad_count, footprints->accesses);
}

} // namespace ffgpu
