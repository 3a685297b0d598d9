// The interpolator: the values of a batch's fragments from their primitives' planes.
//
//     depth           the exact plane, rounded to nearest, clamped to the primitive's range
//     perspective     w = 1 / (plane of 1/w); 1 for primitives whose vertices share one w
//     colours         plane * w, clamped to [0, 1], to 0 .. 255 by floor(v * 255 + 1/2); NaN is 0
//     texture, fog    plane * w, binary32
//
// Everything is evaluated directly at the pixel, so that no result depends on the order of the
// fragments. docs/arithmetic/raster.md has the rules; the _scalar functions are their text.

#pragma once

#include "model/packets/fragment_batch.h"
#include "model/packets/interpolants.h"
#include "model/raster/quad_collector.h"

#include <array>
#include <span>

namespace ffgpu {

// What the evaluation of a batch's planes shares: pixels relative to the tile's corner, and w.
// Needed only where the batch's runs have planes to evaluate: see needs_perspective().
struct PerspectivePlanes {
    alignas(64) std::array<float, BatchFragments> x, y, w;
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

void interpolate_tex_coords(const InterpolantLayout& layout,
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

} // namespace ffgpu
