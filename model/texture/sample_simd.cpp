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

// What the accesses of a batch are put together from.
class AccessRecorder {
public:
    AccessRecorder(const TextureUnit& unit,
                   const FilterInputs& in,
                   const FragmentMask& live,
                   AccessLog& log)
        : in_(in)
        , sampling_(*in.sampling)
        , live_(live)
        , log_(log)
        , is_cube_(unit.kind == TextureKind::Cube)
        , axes_(static_cast<std::uint8_t>((1u << unit.dimensions) - 1)) {}

    // Appends the live lanes' accesses, quad by quad.
    void append_to(TexelAccesses& out) {
        const unsigned levels = sampling_.any_weight() ? 2 : 1;
        out.make_room(in_.quad_count, std::size_t{4} * in_.quad_count * levels);
        if (all_alike()) return out.add(in_.quad_count, common_of(0, 0xf), places());
        for (unsigned quad = 0; quad < in_.quad_count;) {
            const unsigned end = end_of_run(quad);
            if (end > quad)
                add_run(quad, end, out);
            else if (const unsigned lanes = live_.quad(quad); is_regular(quad, lanes))
                add_regular(quad, lanes, out);
            else
                add_whole(quad, lanes, out);
            quad = std::max(end, quad + 1);
        }
    }

private:
    const TexelAccesses::Place* places() const { return log_.first.level.places.data(); }

    // All lanes have one regular access of one kind.
    bool all_alike() const {
        return sampling_.max_probes == 1 && !sampling_.any_weight() && sampling_.one_level() &&
               sampling_.any_linear() != sampling_.any_nearest() && !is_cube_ &&
               !log_.first.irregular.any() && live_.count() == 4 * in_.quad_count;
    }

    bool is_regular(unsigned quad, unsigned lanes) const {
        if (sampling_.max_probes > 1 || (log_.first.irregular.quad(quad) & lanes) != 0)
            return false;
        const std::uint32_t* const choice = sampling_.choice.data() + 4 * quad;
        std::uint32_t different =
            (choice[0] ^ choice[1]) | (choice[0] ^ choice[2]) | (choice[0] ^ choice[3]);
        if (two_levels(4 * quad)) different |= (choice[0] + 1 - (choice[0] >> 8)) & 0xff;
        for (unsigned lane = 4 * quad; is_cube_ && lane < 4 * quad + 4; ++lane)
            different |= static_cast<std::uint32_t>(in_.face[lane] ^ in_.face[4 * quad]);
        return different == 0;
    }
    bool two_levels(unsigned lane) const { return (sampling_.choice[lane] >> 16 & 0xff) != 0; }

    // From `first` on, of quads that all have the same of four lanes; `first`: of none.
    unsigned end_of_run(unsigned first) const {
        if (is_cube_) return first;
        unsigned end = first;
        const auto kind = [this](unsigned quad) { return sampling_.choice[4 * quad] & ~0xff0000u; };
        while (end < in_.quad_count && live_.quad(end) == 0xf && is_regular(end, 0xf) &&
               kind(end) == kind(first) && two_levels(4 * end) == two_levels(4 * first))
            ++end;
        return end;
    }

    void add_run(unsigned first, unsigned end, TexelAccesses& out) const {
        const RegularAccesses common = common_of(first, 0xf);
        if (!common.next_level) return out.add(end - first, common, places() + 4 * first);
        std::array<TexelAccesses::Place, std::size_t{2} * BatchFragments> in_turn;
        TexelAccesses::Place* to = in_turn.data();
        for (unsigned lane = 4 * first; lane < 4 * end; ++lane) {
            *to++ = log_.first.level.places[lane];
            *to++ = log_.first.next_level.places[lane];
        }
        out.add(end - first, common, in_turn.data());
    }

    RegularAccesses common_of(unsigned quad, unsigned lanes) const {
        const std::uint32_t choice = sampling_.choice[4 * quad];
        return {.lanes = static_cast<std::uint8_t>(lanes),
                .linear = (choice & SamplingBatch::LinearBit) != 0 ? axes_ : std::uint8_t{0},
                .level = static_cast<std::uint8_t>(choice),
                .layer = static_cast<std::uint8_t>(is_cube_ ? in_.face[4 * quad] : 0),
                .next_level = two_levels(4 * quad)};
    }

    void add_regular(unsigned quad, unsigned lanes, TexelAccesses& out) const {
        const RegularAccesses common = common_of(quad, lanes);
        std::array<TexelAccesses::Place, 8> of_lanes;
        TexelAccesses::Place* to = of_lanes.data();
        for (unsigned lane = 4 * quad; lane < 4 * quad + 4; ++lane) {
            if ((lanes >> lane % 4 & 1) == 0) continue;
            *to++ = log_.first.level.places[lane];
            if (common.next_level) *to++ = log_.first.next_level.places[lane];
        }
        out.add(common, of_lanes.data());
    }

    // Lane by lane, probe after probe, of each the finer level first.
    void add_whole(unsigned quad, unsigned lanes, TexelAccesses& out) {
        accesses_.clear();
        const unsigned probes = sampling_.max_probes > 1 ? sampling_.probes[quad] : 1;
        for (unsigned lane = 4 * quad; lane < 4 * quad + 4; ++lane)
            for (unsigned i = 0; i < probes && (lanes >> lane % 4 & 1) != 0; ++i) {
                const AccessBatch& batch = log_.probe(i);
                const std::uint32_t level = sampling_.choice[lane];
                accesses_.push_back(access_of(batch, batch.level, lane, level));
                if (two_levels(lane))
                    accesses_.push_back(access_of(batch, batch.next_level, lane, level >> 8));
            }
        out.add(accesses_);
    }

    TexelAccess access_of(const AccessBatch& batch,
                          const AccessBatch::Level& of,
                          unsigned lane,
                          std::uint32_t level) const {
        if (batch.whole[lane / 4]) return of.accesses[lane];
        RegularAccesses common = common_of(lane / 4, 0xf);
        common.layer = static_cast<std::uint8_t>(is_cube_ ? in_.face[lane] : 0);
        const bool linear = (sampling_.choice[lane] & SamplingBatch::LinearBit) != 0;
        common.linear = linear ? axes_ : std::uint8_t{0};
        return common.access(static_cast<std::uint16_t>(lane % 4),
                             static_cast<std::uint8_t>(level),
                             of.places[lane]);
    }

    const FilterInputs& in_;
    const SamplingBatch& sampling_;
    const FragmentMask& live_;
    AccessLog& log_;
    const bool is_cube_;
    const std::uint8_t axes_;           // TexelAccess::linear of linear filters
    std::vector<TexelAccess> accesses_; // of a quad
};

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
    if (footprints) AccessRecorder(unit, inputs, quads.live, log).append_to(footprints->accesses);
}

} // namespace ffgpu
