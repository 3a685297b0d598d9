// FragmentBatch: up to 64 quads of one screen tile, of draws whose pixels are made alike (of a
// single draw where a work sink or a probe tells draws apart), in structure-of-arrays form. It is
// what passes from stage to stage of the fragment pipe, what the work stream records, and what an
// RTL stage is fed with.
//
// A quad is 2x2 pixels at even coordinates; its fragments are lanes 4q .. 4q + 3 in the order
// (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1). All four lanes of a quad are computed up to the
// texture coordinates (a level of detail needs neighbours); `live` tells which count.
//
// No pixel is live twice in a batch, so a stage may treat its fragments in any order. Neighbours
// along a shared edge may both have the quad, each with its own live lanes: a stage must not store
// dead lanes.
//
// Where the targets have several samples a pixel, that holds for samples: a fragment covers some of
// its pixel's, and no sample is live twice.

#pragma once

#include "model/base/one_store.h"
#include "model/device/layout/limits.h"

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace ffgpu {

constexpr unsigned BatchQuads = 64;
constexpr unsigned BatchFragments = 4 * BatchQuads;

// One bit a fragment, bit i % 64 of word i / 64 for lane i.
struct FragmentMask {
    alignas(32) std::array<std::uint64_t, BatchFragments / 64> words{};

    static FragmentMask of(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
        FragmentMask mask;
        store_at_once(mask.words.data(), a, b, c, d);
        return mask;
    }

    bool any() const { return (words[0] | words[1] | words[2] | words[3]) != 0; }
    bool test(unsigned lane) const { return (words[lane / 64] >> (lane % 64)) & 1; }
    void set(unsigned lane) { words[lane / 64] |= std::uint64_t{1} << (lane % 64); }
    // The four bits of quad q, bit i for its lane i.
    unsigned quad(unsigned q) const {
        return static_cast<unsigned>(words[q / 16] >> (4 * (q % 16))) & 0xf;
    }
    unsigned count() const {
        unsigned sum = 0;
        for (const std::uint64_t word : words)
            sum += static_cast<unsigned>(std::popcount(word));
        return sum;
    }
    // Bytes for Highway's LoadMaskBits: byte i holds lanes 8 i .. 8 i + 7 (little endian hosts).
    const std::uint8_t* bytes() const {
        return reinterpret_cast<const std::uint8_t*>(words.data());
    }
    std::uint8_t* bytes() { return reinterpret_cast<std::uint8_t*>(words.data()); }

    bool operator==(const FragmentMask&) const = default;
};

inline FragmentMask operator&(FragmentMask a, const FragmentMask& b) {
    for (std::size_t i = 0; i < a.words.size(); ++i)
        a.words[i] &= b.words[i];
    return a;
}

// Four channels of 256 fragments, each value 0 .. 255 (8-bit unsigned normalised) held in 16 bits:
// the lanes that products need.
struct ColorPlanes {
    alignas(64) std::array<std::uint16_t, BatchFragments> r, g, b, a;
};

// Texture coordinates of one unit, perspective and q already divided out; of cube maps a direction
// of any length. Ordinary numbers: none is subnormal, infinite or NaN.
struct TexCoordPlanes {
    alignas(64) std::array<float, BatchFragments> s, t, r;
};

// Four masks, one a sample: the fragments that cover it.
using SampleMasks = std::array<FragmentMask, MaxSamples>;

inline FragmentMask any_sample(const SampleMasks& samples) {
    FragmentMask any;
    for (const FragmentMask& mask : samples)
        for (std::size_t i = 0; i < any.words.size(); ++i)
            any.words[i] |= mask.words[i];
    return any;
}

// In units of the depth target, one array a sample.
struct SampleDepths {
    alignas(64) std::array<std::array<std::uint32_t, BatchFragments>, MaxSamples> of;
};

struct FragmentBatch {
    unsigned quad_count = 0;
    std::uint16_t tile_x = 0, tile_y = 0; // the tile's lower left pixel

    // Per quad.
    // Window pixel of lane 0, even. Vectors of quads may run over the end.
    static constexpr unsigned PaddedQuads = BatchQuads + 32;
    alignas(64) std::array<std::uint16_t, PaddedQuads> x, y;
    std::array<std::uint32_t, BatchQuads> primitive;         // PrimitiveKey::primitive
    std::array<std::uint64_t, BatchQuads / 64> front_facing; // one bit a quad

    FragmentMask live; // Covered, and not killed so far. Bits of lanes >= 4 quad_count are 0.

    // Per fragment.
    alignas(64) std::array<std::uint32_t, BatchFragments> depth; // in units of the depth target
    alignas(64) std::array<float, BatchFragments> fog_coordinate;
    alignas(64) std::array<std::uint16_t,
                           BatchFragments> antialias; // 0 .. 255 coverage, if the draw has it
    ColorPlanes primary;
    // Channels of `primary`, a bit each, that are known to be 255 in every lane.
    std::uint8_t full_channels = 0;
    ColorPlanes secondary;                         // a is 0
    std::array<ColorPlanes, TextureUnits> texture; // samples; only of the draw's enabled units
    ColorPlanes color; // after the environments; then the running colour down to the blend

    // Multisampled targets only.
    SampleMasks samples; // Covered, and not killed so far; `live` is their union.
    const SampleDepths* sample_depths = nullptr; // null: `depth` is the depth of all samples

    unsigned lanes() const { return 4 * quad_count; }
};

} // namespace ffgpu
