// The texture unit's vector stages, and what passes between them. Each equals the scalar code of
// the same purpose bit for bit.
//
//   project_batch (coordinates.h, cube maps only) -> choose_levels_batch (level_of_detail.h)
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

// Of cube maps: coordinates on the fragment's face, and on the face of the quad's first covered
// fragment for its level of detail.
struct ProjectedBatch {
    TexCoordPlanes sample;
    TexCoordPlanes level_of_detail;
    alignas(64) std::array<std::int32_t, BatchFragments> face;
    std::array<bool, BatchQuads> one_face;
};

// What levels of detail are chosen from: coordinates of whole groups, and of cube maps which quads
// lie on one face.
struct LevelInputs {
    const TexCoordPlanes* coordinates = nullptr;
    const bool* one_face = nullptr; // null: all
};

// How each fragment is sampled, in one word: level in bits 7..0, next level in 15..8, weight in
// 23..16, and bit 24 for a linear filter.
struct SamplingBatch {
    static constexpr std::uint32_t LinearBit = 1u << 24, WeightBits = 0xff << 16;

    alignas(64) std::array<std::uint32_t, BatchFragments> choice;
    std::uint32_t all_of = ~0u; // AND and OR of all words
    std::uint32_t any_of = 0;
    // Only if the unit's max_probes > 1. Steps are per fragment, equal in a quad.
    unsigned max_probes = 1;
    std::array<std::uint8_t, BatchQuads> probes;
    TexCoordPlanes major_step;

    bool any_linear() const { return (any_of & LinearBit) != 0; }
    bool any_nearest() const { return (all_of & LinearBit) == 0; }
    bool any_weight() const { return (any_of & WeightBits) != 0; }
    bool one_level() const { return ((all_of ^ any_of) & 0xff) == 0; }
    bool one_next_level() const { return ((all_of ^ any_of) >> 8 & 0xff) == 0; }
};

// Of whole groups of directions.
void project_batch(const TexCoordPlanes& directions, const SampleQuads& quads, ProjectedBatch& out);

void choose_levels_batch(const TextureUnit& unit,
                         const LevelInputs& inputs,
                         unsigned quad_count,
                         SamplingBatch& out);

struct FilterInputs {
    const TexCoordPlanes* coordinates;
    const float* reference;   // r of each fragment: what depths are compared with
    const std::int32_t* face; // of cube maps
    const SamplingBatch* sampling;
    unsigned quad_count;
};

// Whether this processor has vectors that filter_batch can use.
bool can_filter_batches();

// Writes whole groups of quads.
void filter_batch(const TextureUnit& unit, const FilterInputs& inputs, ColorPlanes& out);

// The accesses that filter_batch makes, one for each lane of whole groups of quads: to the level,
// and to the next level, which counts where the choice has a weight; null: for nobody.
struct AccessPlanes {
    AccessPlane* level = nullptr;
    AccessPlane* next_level = nullptr;
};
void record_batch(const TextureUnit& unit, const FilterInputs& inputs, const AccessPlanes& out);

// The lanes whose next level counts. Those behind the last quad may be anything.
FragmentMask weighted_lanes(const SamplingBatch& sampling, unsigned quad_count);

} // namespace ffgpu
