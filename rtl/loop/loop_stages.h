// The stages that units carry out, by the names that they have in the tables of the model.

#pragma once

#include "model/gpu/stages.h"

namespace ffgpu::rtl {

// texture_environment, color_sum, fog, apply_coverage, alpha_test
void run_environment(const EnvironmentProgram& program, unsigned i, FragmentBatch& batch);
void add_secondary(FragmentBatch& batch);
void apply_fog(const FogCurve& curve, FragmentBatch& batch);
void apply_coverage(FragmentBatch& batch);
FragmentMask alpha_test(const FragmentControl& control, const FragmentBatch& batch);

// stencil_depth, blend
StencilDepthFates test_depth_target(const StencilDepthState& state,
                                    const Surface& target,
                                    const FragmentBatch& batch,
                                    std::span<std::byte> memory);
void write_color(const ColorStage& stage,
                 const ColorTarget& target,
                 const FragmentBatch& batch,
                 std::span<std::byte> memory);

// tile_walker; the others count what it does not do.
void cover_tile(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage);
void cover_windows(const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage);
void cover_tile_samples(const SetupRecord& record,
                        const Rectangle& tile,
                        TileSampleCoverage& coverage);
BlockMask smooth_block(const SetupRecord& record, int x, int y, BlockAntialias& antialias);

// depth_plane; the second counts.
void interpolate_depth(BatchRuns runs, FragmentBatch& batch);
void interpolate_sample_depths(BatchRuns runs, const FragmentBatch& batch, SampleDepths& depths);

// attribute_plane, reciprocal, perspective
void interpolate_perspective(BatchRuns runs,
                             const FragmentBatch& batch,
                             PerspectivePlanes& perspective);
void interpolate_colors(const InterpolantLayout& layout,
                        BatchRuns runs,
                        const PerspectivePlanes& perspective,
                        FragmentBatch& batch);
void interpolate_tex_coords(const InterpolantLayout& layout,
                            unsigned unit_number,
                            BatchRuns runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out);
void interpolate_directions(const InterpolantLayout& layout,
                            unsigned unit_number,
                            BatchRuns runs,
                            const PerspectivePlanes& perspective,
                            const FragmentBatch& batch,
                            TexCoordPlanes& out);

// The model's coordinates, of a batch that is to be sampled.
void make_tex_coords(const InterpolantLayout& layout,
                     unsigned unit_number,
                     BatchRuns runs,
                     const PerspectivePlanes& perspective,
                     const FragmentBatch& batch,
                     TexCoordPlanes& out);
void make_directions(const InterpolantLayout& layout,
                     unsigned unit_number,
                     BatchRuns runs,
                     const PerspectivePlanes& perspective,
                     const FragmentBatch& batch,
                     TexCoordPlanes& out);

// level_of_detail, texel_address, texel_decode, filter_tree
void sample(const TextureUnit& unit,
            TexCoordPlanes& coordinates,
            const SampleQuads& quads,
            ColorPlanes& out,
            TexelFootprints* footprints);

} // namespace ffgpu::rtl
