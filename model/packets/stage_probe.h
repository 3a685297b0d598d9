// StageProbe: what entered and left each stage of the functional GPU, a call a batch and stage. A
// consumer derives one, overrides the stages that it reads, and attaches it with
// FunctionalGpu::set_stage_probe(). A probe never changes a pixel.
//
// Order: set_up() comes while commands are submitted, for each primitive in order. The other calls
// come when a bin is carried out: tile after tile in row order from the lower left, in a tile batch
// after batch in the order of the commands, of a batch the stages in the order they have below (the
// fragment pipe's for each sample in turn). With a probe attached the tiles are carried out on one
// thread, that of the caller of the GPU: calls never overlap, and their order does not depend on
// the number of threads. Batches do depend on the tile size; no value of a fragment does.
//
// A call's arguments live until it returns. Values stand at lanes: lane 4 q + i is fragment i of
// the batch's quad q. Lanes that are not live hold what the stage made of them, which may be
// nothing.
//
// Stages that a batch does not pass are not called: a test that is off, texture units that are not
// sampled, everything behind early depth where nobody is left.

#pragma once

#include "model/packets/fragment_batch.h"
#include "model/packets/fragment_key.h"
#include "model/packets/interpolants.h"
#include "model/packets/texel_footprint.h"
#include "model/packets/window_vertex.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace ffgpu {

struct Registers;   // model/device/registers.h
struct SetupRecord; // model/raster/setup_record.h

namespace probed {

template <class T>
using Lanes = std::array<T, BatchFragments>;

using Rgba = std::array<std::uint8_t, 4>; // 0 .. 255

// --- Whose values

// The quads of one primitive: from first_quad on, up to the next run's.
struct Run {
    const SetupRecord* record;
    unsigned first_quad;
};

struct Batch {
    std::uint32_t draw = 0; // PrimitiveKey::draw
    std::uint32_t frame = 0;
    const Registers* registers = nullptr;
    std::span<const Run> runs{};              // Of drawn pixels none: they have no primitives.
    std::span<const std::uint32_t> pieces{};  // of each quad, as fragment_key.h counts them
    const FragmentBatch* fragments = nullptr; // as it is behind the stage
};

// The fragment's name, or its sample's: as in the work stream, and so the same whatever batches the
// host made.
inline FragmentKey key_of(const Batch& batch, unsigned lane, unsigned sample = 0) {
    const FragmentBatch& fragments = *batch.fragments;
    const unsigned quad = lane / 4;
    const struct {
        std::uint32_t piece;
        std::uint16_t x, y;
    } place{batch.pieces[quad], fragments.x[quad], fragments.y[quad]};
    return {batch.draw, fragments.primitive[quad], fragment_sequence(place, lane % 4, sample)};
}

// --- Set-up, coverage, interpolation

struct SetUp {
    std::uint32_t draw = 0, frame = 0;
    const Registers* registers = nullptr;
    const Primitive* primitive = nullptr; // with its vertices
    const SetupRecord* record = nullptr;  // null: it covers nothing
};

// The edge functions at the pixels' centres; a centre is inside where all are >= 0. Those that the
// lane's record has; the others are 0.
struct Coverage {
    static constexpr unsigned Edges = 4;
    std::array<Lanes<std::int64_t>, Edges> edges;
};

struct Perspective {
    Lanes<double> inverse_w; // the plane's value, exact, in the record's scale
    Lanes<float> w;          // its reciprocal
};

// The planes' values before w: exact, in the record's scale, colours 255 times as large.
struct Colors {
    std::array<Lanes<double>, 4> primary_over_w, secondary_over_w;
    Lanes<double> fog_over_w;
};

struct TexCoords {
    unsigned unit = 0;
    unsigned carried = 0;                // 2: s t, 3: s t r, 4: s t r q; the others have no plane
    std::array<Lanes<double>, 4> over_w; // as in Colors
    const TexCoordPlanes* result = nullptr;
};

// --- The texture unit
// Of live lanes. All of it is the scalar specification's account of the stage.

// What a quad chose; its fragments share it.
struct QuadLevels {
    std::uint8_t quad = 0;
    std::uint8_t probes = 1; // anisotropic ones along the longer side
    std::uint8_t level = 0, next_level = 0;
    std::uint8_t weight = 0; // of the next level, in 256ths
    bool linear = false;
    std::array<float, 3> step_x{}, step_y{}; // derivatives of s t r (cube maps: on the face)
    float footprint_x = 0, footprint_y = 0;  // squared sides in texels of level 0
    std::int32_t lambda = 0;                 // 8 fraction bits, biased and clamped
};

struct Texel {
    static constexpr unsigned MostBytes = 16;

    std::uint16_t x = 0, y = 0, layer = 0; // as in TexelAccess; BorderTexel: the border's colour
    std::uint8_t bytes = 0;                // of the texel or its compressed block; border: 0
    std::array<std::byte, MostBytes> stored{};
    Rgba color{}; // decoded, linear, compared
};

// One level's filter for one fragment and probe. Texels stand x first, then y, then layers; with a
// nearest filter there is one. along_x[i] is the interpolation of texels 2 i and 2 i + 1,
// along_y[i] that of along_x[2 i] and [2 i + 1], `color` that of along_y[0] and [1]; an axis that
// the filter does not have hands its first on. A filter that weights its texels one by one
// (model/texture/wide_filters.h) has no interpolations, but weights in units of its own.
struct LevelFilter {
    TexelAccess access{};
    std::uint8_t probe = 0;               // from 0
    std::array<std::uint8_t, 3> weight{}; // of the second texel along x, y, layers, in 256ths
    std::uint8_t texel_count = 0;
    std::array<Texel, 8> texels{};
    std::optional<std::array<std::int32_t, 4>> texel_weights{};
    std::uint8_t along_x_count = 0, along_y_count = 0;
    std::array<Rgba, 4> along_x{};
    std::array<Rgba, 2> along_y{};
    Rgba color{};
};

// One probe of one fragment.
struct Probe {
    std::uint16_t lane = 0;
    std::uint8_t probe = 0;             // from 0
    std::uint8_t face = 0;              // of a cube map
    std::array<float, 3> coordinates{}; // s t r after the division (cube maps: on the face)
    std::uint32_t weight = 1;           // in the mean of the fragment's probes
    std::uint8_t next_level = 0;        // weight of the next level, in 256ths
    std::uint32_t level_filter = 0;     // its first one, then those that follow
    std::uint32_t level_filters = 0;    // 1, or 2 where the next level has a weight; of a wide
                                        // filter as many as it made accesses
    Rgba color{};                       // of all levels
};

// A fragment's colour is the weighted mean of its probes'.
struct Sampling {
    unsigned unit = 0;
    const TexCoordPlanes* coordinates = nullptr;
    std::span<const QuadLevels> quads{};
    std::span<const Probe> probes{};              // by lane: up to 16 a lane, and a rip-map's
                                                  // four images are four
    std::span<const LevelFilter> level_filters{}; // of all probes
    const ColorPlanes* result = nullptr;          // what the stage gave
};

// --- The fragment pipe

struct Environment {
    unsigned unit = 0;
    const ColorPlanes* previous = nullptr; // The result is fragments->color.
};

struct Fog {
    const ColorPlanes* before = nullptr;
    Lanes<std::uint8_t> factor; // 255: no fog
};

struct Test {
    bool on = true;
    FragmentMask before, after;
};

// Of one sample's plane of the depth target. Depths in its units; where it has no stencil, 0.
struct StencilDepth {
    unsigned sample = 0;
    bool early = false, on = true;
    FragmentMask before, after_stencil, after_depth;
    Lanes<std::uint32_t> stored_depth, new_depth;
    Lanes<std::uint8_t> stored_stencil, new_stencil;
};

// Of one sample's plane of one colour target, for the lanes of `written`; rgba8 with red lowest.
// The source is fragments->color.
struct ColorWrite {
    unsigned target = 0, sample = 0;
    FragmentMask written;
    Lanes<std::uint32_t> destination; // as it reads before
    Lanes<std::uint32_t> blended; // before write mask, logic operation and the target's precision
    Lanes<std::uint32_t> stored;  // as it reads afterwards
};

} // namespace probed

class StageProbe {
public:
    virtual ~StageProbe() = default;

    virtual void set_up(const probed::SetUp&) {}

    // fragments: positions, live, antialias, samples.
    virtual void coverage(const probed::Batch&, const probed::Coverage&) {}
    // fragments: depth, or sample_depths where primitives cover samples.
    virtual void depth(const probed::Batch&) {}
    // The early test, where it is one: stencil_depth(), then
    virtual void perspective(const probed::Batch&, const probed::Perspective&) {}
    // fragments: primary, secondary, fog_coordinate.
    virtual void colors(const probed::Batch&, const probed::Colors&) {}
    virtual void tex_coords(const probed::Batch&, const probed::TexCoords&) {}
    // fragments: texture[unit].
    virtual void sampling(const probed::Batch&, const probed::Sampling&) {}

    // fragments: color.
    virtual void environment(const probed::Batch&, const probed::Environment&) {}
    virtual void color_sum(const probed::Batch&, const ColorPlanes& /*before*/) {}
    virtual void fog(const probed::Batch&, const probed::Fog&) {}
    virtual void antialias(const probed::Batch&, const ColorPlanes& /*before*/) {}
    // fragments: samples, and alpha where it becomes 1. Multisampled targets.
    virtual void sample_mask(const probed::Batch&, const SampleMasks& /*before*/) {}
    // The two tests are told where they are switched off, too: all pass then, or a stage is wrong.
    virtual void alpha_test(const probed::Batch&, const probed::Test&) {}
    virtual void stencil_depth(const probed::Batch&, const probed::StencilDepth&) {}
    virtual void color_write(const probed::Batch&, const probed::ColorWrite&) {}
};

// A probe, and the batch under way.
struct ProbeTap {
    StageProbe& probe;
    probed::Batch batch;
};

} // namespace ffgpu
