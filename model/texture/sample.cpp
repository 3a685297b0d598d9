// The texture unit's scalar specification: one fragment after the other, one texel after the other.

#include "model/texture/coordinates.h"
#include "model/texture/depth_compare.h"
#include "model/texture/level_of_detail.h"
#include "model/texture/probe_filter.h"
#include "model/texture/texel_read.h"
#include "model/texture/texture_unit.h"
#include "model/texture/wide_filters.h"

#include <array>

namespace ffgpu {
namespace {

struct Neighbourhood {
    std::array<AxisTexels, 3> axes;
    bool linear = false;
};

AxisTexels
axis_texels(const TextureUnit& unit, unsigned axis, unsigned level, float s, bool linear) {
    const WrapRule& rule = linear ? unit.linear_rules[axis] : unit.nearest_rules[axis];
    const std::int32_t size = level_extent(unit, axis, level);
    const float scale = unit.normalized ? static_cast<float>(256 * size) : 256.0f;
    const float folded = fold_coordinate(rule.fold, s, unit.extent[axis]);
    const std::int32_t coordinate = texel_coordinate(folded, scale, size, rule);
    return linear ? linear_texels(coordinate, size, rule) : nearest_texel(coordinate, size, rule);
}

Neighbourhood
neighbourhood(const TextureUnit& unit, const TexCoord& coord, unsigned level, bool linear) {
    Neighbourhood result{{}, linear};
    const std::array<float, 3> coords{coord.s, coord.t, coord.r};
    for (unsigned axis = 0; axis < unit.dimensions; ++axis)
        result.axes[axis] = axis_texels(unit, axis, level, coords[axis], linear);
    return result;
}

TexelAccess make_access(const TextureUnit& unit,
                        const Neighbourhood& near,
                        unsigned level,
                        unsigned face,
                        unsigned lane) {
    const auto stored = [&](unsigned axis, std::int32_t index) -> std::uint16_t {
        if (axis >= unit.dimensions) return static_cast<std::uint16_t>(axis == 2 ? face : 0);
        return stored_coordinate(unit, index, level_extent(unit, axis, level));
    };
    const auto& [x, y, z] = near.axes;
    const unsigned linear = near.linear ? (1u << unit.dimensions) - 1 : 0;
    return {static_cast<std::uint16_t>(lane),
            static_cast<std::uint8_t>(level),
            static_cast<std::uint8_t>(linear),
            stored(0, x.first),
            stored(0, x.second),
            stored(1, y.first),
            stored(1, y.second),
            stored(2, z.first),
            stored(2, z.second)};
}

// Horizontally, then vertically, then between slices; an axis that the filter does not have, or a
// nearest filter, reads no second texel.
Rgba filter_level(const TextureUnit& unit,
                  const SampledFragment& fragment,
                  unsigned level,
                  bool linear,
                  const FilterWitness& witness) {
    const Neighbourhood near = neighbourhood(unit, fragment.coord, level, linear);
    const AxisTexels &x = near.axes[0], &y = near.axes[1], &z = near.axes[2];
    const TexelAccess access = make_access(unit, near, level, fragment.face, witness.lane);
    witness.tell(access, near.axes);

    const auto texel = [&](std::int32_t at_x, std::int32_t at_y, std::int32_t at_z) {
        const TexelPlace place{level, fragment.face, at_x, at_y, at_z};
        return read_texel(unit, place, fragment.reference, witness.observer);
    };
    const auto row = [&](std::int32_t at_y, std::int32_t at_z) {
        const Rgba first = texel(x.first, at_y, at_z);
        return witness.told(0,
                            linear ? lerp8w(first, texel(x.second, at_y, at_z), x.weight) : first);
    };
    const auto slice = [&](std::int32_t at_z) {
        const Rgba first = row(y.first, at_z);
        if (!linear || unit.dimensions < 2) return witness.told(1, first);
        return witness.told(1, lerp8w(first, row(y.second, at_z), y.weight));
    };
    const Rgba first = slice(z.first);
    if (!linear || unit.dimensions < 3) return witness.told(2, first);
    return witness.told(2, lerp8w(first, slice(z.second), z.weight));
}

} // namespace

Rgba filter_levels(const TextureUnit& unit,
                   const SampledFragment& fragment,
                   const QuadSampling& quad,
                   const FilterWitness& witness) {
    witness.begin_probe(fragment, quad.weight);
    const Rgba fine = filter_level(unit, fragment, quad.level, quad.linear, witness);
    if (quad.weight == 0) return witness.told(3, fine);
    const Rgba coarse = filter_level(unit, fragment, quad.next_level, quad.linear, witness);
    return witness.told(3, lerp8w(fine, coarse, quad.weight));
}

namespace {

SampledFragment probe(const SampledFragment& fragment, const QuadSampling& quad, unsigned i) {
    const float at = probe_position(i, quad.probes);
    SampledFragment result = fragment;
    result.coord.s = move_to_probe(fragment.coord.s, quad.major_step.s, at);
    result.coord.t = move_to_probe(fragment.coord.t, quad.major_step.t, at);
    result.coord.r = move_to_probe(fragment.coord.r, quad.major_step.r, at);
    return result;
}

Rgba filter_fragment(const TextureUnit& unit,
                     const SampledFragment& fragment,
                     const QuadSampling& quad,
                     const FilterWitness& witness) {
    if (is_wide(unit, quad)) return filter_wide(unit, fragment, quad, witness);
    if (quad.probes == 1) return filter_levels(unit, fragment, quad, witness);
    std::array<unsigned, 4> sum{};
    for (unsigned i = 1; i <= quad.probes; ++i) {
        const Rgba sampled = filter_levels(unit, probe(fragment, quad, i), quad, witness);
        for (unsigned channel = 0; channel < 4; ++channel)
            sum[channel] += sampled[channel];
    }
    Rgba mean{};
    for (unsigned channel = 0; channel < 4; ++channel)
        mean[channel] = static_cast<std::uint8_t>((sum[channel] + quad.probes / 2u) / quad.probes);
    return mean;
}

struct Quad {
    std::array<SampledFragment, 4> fragments;
    QuadSampling sampling;
};

Quad make_quad(const TextureUnit& unit,
               const TexCoordPlanes& planes,
               unsigned first_lane,
               unsigned covered) {
    Quad quad;
    std::array<TexCoord, 4> coords;
    bool one_face = true;
    const unsigned quad_face = cube_face(coordinates_of(planes, first_lane + face_lane(covered)));
    for (unsigned i = 0; i < 4; ++i) {
        coords[i] = coordinates_of(planes, first_lane + i);
        SampledFragment& fragment = quad.fragments[i];
        fragment.reference = reference_depth(coords[i].r);
        fragment.coord = coords[i];
        if (unit.kind != TextureKind::Cube) continue;
        fragment.face = cube_face(coords[i]);
        fragment.coord = project_to_face(fragment.face, coords[i]);
        coords[i] = project_to_face(quad_face, coords[i]);
        one_face &= fragment.face == quad_face;
    }
    quad.sampling = sample_quad(unit, coords, one_face);
    return quad;
}

void store(ColorPlanes& out, unsigned lane, const Rgba& color) {
    out.r[lane] = color[0];
    out.g[lane] = color[1];
    out.b[lane] = color[2];
    out.a[lane] = color[3];
}

} // namespace

void sample_scalar(const TextureUnit& unit,
                   const TexCoordPlanes& coordinates,
                   const SampleQuads& quads,
                   ColorPlanes& out,
                   TexelFootprints* footprints,
                   TexelObserver* observer) {
    for (unsigned lane = 0; lane < 4 * quads.count && !unit.valid; ++lane)
        store(out, lane, {0, 0, 0, 255});
    for (unsigned q = 0; q < quads.count && unit.valid; ++q) {
        const Quad quad = make_quad(unit, coordinates, 4 * q, quads.covered.quad(q));
        if (observer && quads.live.quad(q) != 0) observer->quad(q, quad.sampling);
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned lane = 4 * q + i;
            const bool told = quads.live.test(lane);
            const FilterWitness witness{
                told ? observer : nullptr, told ? footprints : nullptr, lane};
            store(out, lane, filter_fragment(unit, quad.fragments[i], quad.sampling, witness));
        }
    }
}

} // namespace ffgpu
