// The interpolator: the values of a batch's fragments from their primitives' planes.
//
//     depth        the exact plane, rounded to nearest, clamped to the primitive's range
//     perspective  w = 1 / (plane of 1/w), of its integer; 1 where the vertices share one w
//     colours      plane * w, clamped to 0 .. 255, by floor(v + 1/2)
//     fog          plane * w, binary32, in fog's range
//     texture      plane * w; where q varies plane * (1 / plane of q), one division for all
//     directions   of cube maps: the planes themselves, whose length does not matter
//
// A quad's corner comes first, in integers, then its lanes: no result depends on the order of the
// fragments. docs/arithmetic/raster.md has the rules; the _scalar functions are their text.

#pragma once

#include "model/packets/fragment_batch.h"
#include "model/packets/interpolants.h"
#include "model/raster/quad_collector.h"

#include <array>
#include <cstdint>
#include <span>

namespace ffgpu {

// What the evaluation of a batch's planes shares. Needed only where the batch's runs have planes to
// evaluate: see needs_perspective().
struct PerspectivePlanes {
    // Vectors of lanes, or of quads, may run over the end.
    static constexpr unsigned PaddedLanes = BatchFragments + 16, PaddedQuads = BatchQuads + 16;

    alignas(64) std::array<float, PaddedLanes> w;
    // Of quads' corners: x in the lower half, y in the upper.
    alignas(64) std::array<std::uint32_t, PaddedQuads> places;
};

void interpolate_depth(std::span<const BatchRun> runs, FragmentBatch& batch);

// The same at each sample's position.
void interpolate_sample_depths(std::span<const BatchRun> runs,
                               const FragmentBatch& batch,
                               SampleDepths& depths);

// False where all that the layout carries is constant in every run.
bool needs_perspective(const InterpolantLayout& layout, std::span<const BatchRun> runs);

void interpolate_perspective(std::span<const BatchRun> runs,
                             const FragmentBatch& batch,
                             PerspectivePlanes& perspective);

// primary, secondary and fog_coordinate, as far as the layout has them.
void interpolate_colors(const InterpolantLayout& layout,
                        std::span<const BatchRun> runs,
                        const PerspectivePlanes& perspective,
                        FragmentBatch& batch);

// The primary colour alone, which the layout has, as the words that rgba8 targets hold.
void interpolate_color_words(const InterpolantLayout& layout,
                             std::span<const BatchRun> runs,
                             const PerspectivePlanes& perspective,
                             unsigned lanes,
                             std::span<std::uint32_t, BatchFragments> words);

void interpolate_tex_coords(const InterpolantLayout& layout,
                            unsigned unit,
                            std::span<const BatchRun> runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out);

// For cube maps: a multiple of (s, t, r), the same for all lanes of a primitive.
void interpolate_directions(const InterpolantLayout& layout,
                            unsigned unit,
                            std::span<const BatchRun> runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out);

void interpolate_depth_scalar(std::span<const BatchRun> runs, FragmentBatch& batch);
void interpolate_sample_depths_scalar(std::span<const BatchRun> runs,
                                      const FragmentBatch& batch,
                                      SampleDepths& depths);

void interpolate_perspective_scalar(std::span<const BatchRun> runs,
                                    const FragmentBatch& batch,
                                    PerspectivePlanes& perspective);

void interpolate_colors_scalar(const InterpolantLayout& layout,
                               std::span<const BatchRun> runs,
                               const PerspectivePlanes& perspective,
                               FragmentBatch& batch);

void interpolate_tex_coords_scalar(const InterpolantLayout& layout,
                                   unsigned unit,
                                   std::span<const BatchRun> runs,
                                   const PerspectivePlanes& perspective,
                                   const FragmentBatch& batch,
                                   TexCoordPlanes& out);

void interpolate_directions_scalar(const InterpolantLayout& layout,
                                   unsigned unit,
                                   std::span<const BatchRun> runs,
                                   const PerspectivePlanes& perspective,
                                   const FragmentBatch& batch,
                                   TexCoordPlanes& out);

// The planes of one unit's coordinates in a layout; those that are not carried are 0.
struct TexCoordSource {
    unsigned first = 0, carried = 0, unit = 0;

    TexCoordSource(const InterpolantLayout& layout, unsigned of_unit)
        : first(static_cast<unsigned>(layout.tex_coord[of_unit]))
        , carried(layout.tex_coord[of_unit] < 0 ? 0u : layout.tex_components[of_unit])
        , unit(of_unit) {}

    unsigned coordinates() const { return carried < 3 ? carried : 3; } // without q
    bool divides(const SetupRecord& record) const {
        return (record.divided_units >> unit & 1) != 0;
    }
};

// 2^n by which a coordinate's integer over q's is multiplied.
float divided_scale(float coordinate_scale, float q_scale);

// What brings the directions' integers to one exponent, the greatest of theirs.
std::array<float, 3> direction_scales(const SetupRecord& record, const TexCoordSource& source);

} // namespace ffgpu
