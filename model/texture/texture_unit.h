// The texture unit: a stage over a batch's quads. Texture coordinates in, colours out.
//
//   cube face -> derivatives -> level of detail -> wrap -> texels -> filter
//
// compile_texture_unit() turns the two registers into a TextureUnit once a draw; sample() then
// carries out a batch with vectors (sample_simd.cpp), sample_scalar() with plain scalar code, which
// is the specification (sample.cpp; docs/arithmetic/texture.md): both give the same bits. Start
// reading at sample.cpp: filter_fragment() and, above it, what it calls.

#pragma once

#include "model/device/registers/texture.h"
#include "model/packets/fragment_batch.h"
#include "model/packets/texel_footprint.h"
#include "model/texture/wrap.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace ffgpu {

// Levels as one array a property, padded to a power of two: a vector gathers from them.
struct LevelTable {
    static constexpr unsigned Size = 16;

    std::array<std::uint32_t, Size> offset{};       // bytes from the texture's first
    std::array<std::uint32_t, Size> row_stride{};   // bytes
    std::array<std::uint32_t, Size> layer_stride{}; // bytes
};

struct TextureUnit {
    bool valid = false; // An image was given, and all of it lies in memory. Else: opaque black.

    TextureKind kind = TextureKind::None;
    Format format = Format::None;
    bool srgb = false;                  // r, g and b of its texels become linear light
    unsigned dimensions = 2;            // of the filter: 1, 2 or 3
    std::array<std::int32_t, 3> size{}; // of level 0, in texels, without the border
    std::int32_t border = 0;            // texels stored around the image: 0 or 1
    std::uint32_t last_level = 0;       // the coarsest that may be used
    const std::byte* texels = nullptr;  // level 0's first byte
    LevelTable levels;

    bool normalized = true;         // coordinates run to 1; else they count texels (rectangle)
    std::array<float, 3> extent{};  // coordinate of the far edge
    std::array<float, 3> density{}; // texels of level 0 for each unit of the coordinate
    std::array<WrapRule, 3> nearest_rules{}, linear_rules{};
    bool border_color = false; // The border colour can be read.

    Sampler sampler;
    TextureFilter filter = TextureFilter::Standard; // that this image can be sampled with
    std::int32_t magnify_limit = 0; // Level of detail, 8 fraction bits, up to which it magnifies.
    unsigned max_probes = 1;

    // The r coordinate is compared with depths.
    bool compares() const { return format_info(format).is_depth && sampler.compare_enable; }
};

// `memory` is the device's; 64 bytes behind it can be read, and their values do not matter.
TextureUnit compile_texture_unit(const TextureImage& image,
                                 const Sampler& sampler,
                                 std::span<const std::byte> memory);

// The quads 0 .. count - 1 of a batch: what the primitives cover of them, and what of that no test
// has killed yet.
struct SampleQuads {
    unsigned count = 0;
    FragmentMask covered, live;
    bool colors = true; // false: nobody wants the colours, which may be any
};

// Samples the quads. Fragments that are not live get some colour. With footprints, appends the
// accesses of the live ones. What stands behind the last quad's coordinates is overwritten.
void sample(const TextureUnit& unit,
            TexCoordPlanes& coordinates,
            const SampleQuads& quads,
            ColorPlanes& out,
            TexelFootprints* footprints);

struct QuadSampling; // level_of_detail.h
struct TexCoord;     // coordinates.h

// Told of what the reference does for the live lanes, in its order; tests hold the footprints
// against it, the stage probe hands it on.
// Of a probe in the mean of the fragment's, and of the next level in the probe, in 256ths.
struct ProbeWeights {
    std::uint32_t probe = 1;
    std::uint8_t next_level = 0;
};

class TexelObserver {
public:
    virtual ~TexelObserver() = default;

    virtual void quad(unsigned /*quad*/, const QuadSampling&) {}
    // A probe of a fragment begins, with its weights; then one level of it: its access, and the
    // texels of each axis.
    virtual void probe(unsigned /*lane*/, unsigned /*face*/, const TexCoord&, const ProbeWeights&) {
    }
    virtual void level(const TexelAccess&, const std::array<AxisTexels, 3>&) {}
    // A texel, at coordinates as in TexelAccess; then its bytes (none where the border colour
    // stands for it) and its colour.
    virtual void read(unsigned level, unsigned layer, unsigned x, unsigned y) = 0;
    virtual void texel(std::span<const std::byte>, const std::array<std::uint8_t, 4>&) {}
    // Of the last four texels, where a filter weights them one by one; in units of its own.
    virtual void texel_weights(const std::array<std::int32_t, 4>&) {}
    // What the filter gave along x (0), y (1), between layers (2), and at last between levels (3).
    virtual void filtered(unsigned /*axis*/, const std::array<std::uint8_t, 4>&) {}
};

void sample_scalar(const TextureUnit& unit,
                   const TexCoordPlanes& coordinates,
                   const SampleQuads& quads,
                   ColorPlanes& out,
                   TexelFootprints* footprints,
                   TexelObserver* observer = nullptr);

} // namespace ffgpu
