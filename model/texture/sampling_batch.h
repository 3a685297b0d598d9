// The texture unit's vector stages, and what passes between them. Each equals the scalar code of
// the same purpose bit for bit.
//
//   project_batch (coordinates.h) -> choose_levels_batch (level_of_detail.h)
//     -> for each anisotropic probe: filter_batch (wrap.h, texel_read.h, filter.h)

#pragma once

#include "model/packets/fragment_batch.h"
#include "model/packets/texel_footprint.h"
#include "model/texture/texture_unit.h"

#include <array>
#include <cstdint>

namespace ffgpu {

// Vectors hold whole groups of 8 quads; the lanes behind the last quad repeat it.
constexpr unsigned QuadGroup = 8;
constexpr unsigned grouped_quads(unsigned quad_count) {
    return (quad_count + QuadGroup - 1) / QuadGroup * QuadGroup;
}

struct CoordinatePlanes {
    alignas(64) std::array<float, BatchFragments> s, t, r;
};

// Coordinates after the division by q, those of them that the unit needs; of cube maps, on the
// fragment's face. `level_of_detail` has them on the face of the quad's first live fragment; only
// cube maps fill it.
struct ProjectedBatch {
    CoordinatePlanes sample;
    CoordinatePlanes level_of_detail;
    alignas(64) std::array<std::int32_t, BatchFragments> face; // only of cube maps
    std::array<bool, BatchQuads> one_face;                     // only of cube maps
};

// How each fragment is sampled, in one word: level in bits 7..0, next level in 15..8, weight in
// 23..16, and bit 24 for a linear filter.
struct SamplingBatch {
    static constexpr std::uint32_t LinearBit = 1u << 24;

    alignas(64) std::array<std::uint32_t, BatchFragments> choice;
    std::uint32_t all_of = ~0u; // AND and OR of all words
    std::uint32_t any_of = 0;
    // Only if the unit's max_probes > 1. Steps are per fragment, equal in a quad.
    unsigned max_probes = 1;
    std::array<std::uint8_t, BatchQuads> probes;
    CoordinatePlanes major_step;

    bool any_linear() const { return (any_of & LinearBit) != 0; }
    bool any_nearest() const { return (all_of & LinearBit) == 0; }
    bool any_weight() const { return (any_of >> 16 & 0xff) != 0; }
    bool one_level() const { return ((all_of ^ any_of) & 0xff) == 0; }
    bool one_next_level() const { return ((all_of ^ any_of) >> 8 & 0xff) == 0; }
};

void project_batch(const TextureUnit& unit,
                   const TexCoordPlanes& coordinates,
                   unsigned quad_count,
                   const FragmentMask& live,
                   ProjectedBatch& out);

void choose_levels_batch(const TextureUnit& unit,
                         const ProjectedBatch& coordinates,
                         unsigned quad_count,
                         SamplingBatch& out);

struct FilterInputs {
    const CoordinatePlanes* coordinates;
    const float* reference;   // r of each fragment: what depths are compared with
    const std::int32_t* face; // of cube maps
    const SamplingBatch* sampling;
    unsigned quad_count;
};

// Whether this processor has vectors that filter_batch can use.
bool can_filter_batches();

// Writes whole groups of quads.
void filter_batch(const TextureUnit& unit, const FilterInputs& inputs, ColorPlanes& out);

// The accesses that filter_batch makes, one for each lane: to the level, and to the next level,
// which counts where the choice has a weight.
struct AccessBatch {
    alignas(64) std::array<TexelAccess, BatchFragments> level, next_level;
};
void record_batch(const TextureUnit& unit, const FilterInputs& inputs, AccessBatch& out);

} // namespace ffgpu
