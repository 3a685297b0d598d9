// Stages: the functions that the functional GPU is made of, in the order of the block diagram.
// There are two tables of them, wired in stages.cpp: the fast forms, and the scalar specifications,
// which draw the same frames bit for bit. What a stage does is in the header of its unit.
//
// What has one form is not here, and runs in both: fetch, assembly, clipping and the set-up of
// single primitives; stipple, batches of quads, images' fragments; the sample mask; clears and
// copies.

#pragma once

#include "model/fragment/fragment_stages.h"
#include "model/geometry/vertex_stages.h"
#include "model/raster/interpolator.h"
#include "model/raster/sample_coverage.h"
#include "model/raster/smooth_coverage.h"
#include "model/raster/triangle_group.h"
#include "model/texture/texture_unit.h"

#include <span>

namespace ffgpu {

using BatchRuns = std::span<const BatchRun>;

struct Stages {
    ShadeVertices shade_vertices;

    SetUpTriangles set_up_triangles; // Of plain ones, several at once.

    // Coverage of a tile: by centres, by samples; of a block: by areas.
    void (*cover_tile)(const EdgeSet&, const Rectangle& tile, TileCoverage&);
    void (*cover_tile_samples)(const SetupRecord&, const Rectangle& tile, TileSampleCoverage&);
    // By centres, in windows, of a primitive of few pixels.
    void (*cover_windows)(const EdgeSet&, const Rectangle& tile, TileCoverage&);
    PackQuads pack_quads; // The quads of a covered block.
    BlockMask (*smooth_block)(const SetupRecord&, int x, int y, BlockAntialias&);

    void (*interpolate_depth)(BatchRuns, FragmentBatch&);
    void (*interpolate_sample_depths)(BatchRuns, const FragmentBatch&, SampleDepths&);
    void (*interpolate_perspective)(BatchRuns, const FragmentBatch&, PerspectivePlanes&);
    void (*interpolate_colors)(const InterpolantLayout&,
                               BatchRuns,
                               const PerspectivePlanes&,
                               FragmentBatch&);
    void (*interpolate_tex_coords)(const InterpolantLayout&,
                                   unsigned unit,
                                   BatchRuns,
                                   const PerspectivePlanes&,
                                   const FragmentBatch&,
                                   TexCoordPlanes&);

    // The same planes for cube maps, whose directions have any length.
    void (*interpolate_directions)(const InterpolantLayout&,
                                   unsigned unit,
                                   BatchRuns,
                                   const PerspectivePlanes&,
                                   const FragmentBatch&,
                                   TexCoordPlanes&);

    // Cube face, level of detail, addressing, texels, filter.
    void (*sample)(
        const TextureUnit&, TexCoordPlanes&, const SampleQuads&, ColorPlanes&, TexelFootprints*);

    const FragmentStages* fragment;

    // Colours that no stage changes go to the targets as words (write_kept).
    bool packs_kept_colors = false;
    // Blocks in which every fragment fails the early depth test are counted and passed over
    // (hidden_blocks.h).
    bool passes_over_hidden = false;
    // Clears leave alone what holds their value already (cleared_tiles.h).
    bool remembers_clears = false;
};

extern const Stages FastStages, ReferenceStages;

} // namespace ffgpu
