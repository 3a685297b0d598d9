// Backends with one fault each: the reference, but for one lane of one quad in one stage.

#pragma once

#include "model/gpu/stages.h"
#include "model/memory/pixel_format.h"
#include "model/raster/interpolator.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ffgpu::test {

// Where the fault is. All stages of the busy scene reach the quad.
constexpr unsigned FaultX = 8, FaultY = 6, FaultLane = 1;
constexpr unsigned FaultPixelX = FaultX + FaultLane % 2, FaultPixelY = FaultY + FaultLane / 2;

// The lane of the batch that is hit; nothing: it is not there, or not live.
inline std::optional<unsigned> fault_lane(const FragmentBatch& batch) {
    for (unsigned quad = 0; quad < batch.quad_count; ++quad)
        if (batch.x[quad] == FaultX && batch.y[quad] == FaultY &&
            batch.live.test(4 * quad + FaultLane))
            return 4 * quad + FaultLane;
    return std::nullopt;
}

inline bool holds_fault(int x, int y) {
    return x <= static_cast<int>(FaultPixelX) && static_cast<int>(FaultPixelX) < x + 8 &&
           y <= static_cast<int>(FaultPixelY) && static_cast<int>(FaultPixelY) < y + 8;
}
inline std::uint64_t fault_bit(int x, int y) {
    return std::uint64_t{1} << block_bit(static_cast<int>(FaultPixelX) - x,
                                         static_cast<int>(FaultPixelY) - y);
}

struct FaultyBackend {
    Stages stages = ReferenceStages;
    FragmentStages fragment = ReferenceFragmentStages;

    FaultyBackend() { stages.fragment = &fragment; }
    FaultyBackend(const FaultyBackend&) = delete;
    FaultyBackend& operator=(const FaultyBackend&) = delete;
};

inline const std::string FaultPlace = " quad 8,6 lane 1 ";

struct Fault {
    const char* part;  // that has to be named
    const char* field; // "": an entry too much or too few
    bool samples;      // in the multisampled scene
    std::string place; // of the entry, or a part of it
    void (*plant)(FaultyBackend&);
};

inline const std::vector<Fault>& planted_faults() {
    static const std::vector<Fault> faults{
        {"set_up",
         "vertex_x[0]",
         false,
         "primitive ",
         [](FaultyBackend& backend) {
             backend.stages.shade_vertices =
                 [](const VertexSetup& setup, VertexBatch& batch, const VertexRecords& records) {
                     ReferenceStages.shade_vertices(setup, batch, records);
                     records.window[0].x += 1; // of each batch's first vertex
                 };
         }},
        {"coverage",
         "covered",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.stages.cover_tile =
                 [](const EdgeSet& edges, const Rectangle& tile, TileCoverage& coverage) {
                     ReferenceStages.cover_tile(edges, tile, coverage);
                     for (unsigned i = 0; i < coverage.count; ++i) {
                         BlockCoverage& block = coverage.blocks[i];
                         if (holds_fault(block.x, block.y))
                             block.mask ^= fault_bit(block.x, block.y);
                     }
                 };
         }},
        {"coverage",
         "samples",
         true,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.stages.cover_tile_samples = [](const SetupRecord& record,
                                                    const Rectangle& tile,
                                                    TileSampleCoverage& coverage) {
                 ReferenceStages.cover_tile_samples(record, tile, coverage);
                 for (unsigned i = 0; i < coverage.count; ++i) {
                     SampleBlock& block = coverage.blocks[i];
                     if (!holds_fault(block.x, block.y)) continue;
                     const std::uint64_t bit = fault_bit(block.x, block.y);
                     if (block.masks[0] & block.masks[1] & bit) block.masks[1] &= ~bit;
                 }
             };
         }},
        {"depth",
         "depth",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.stages.interpolate_depth = [](BatchRuns runs, FragmentBatch& batch) {
                 ReferenceStages.interpolate_depth(runs, batch);
                 if (const auto lane = fault_lane(batch)) batch.depth[*lane] ^= 1;
             };
         }},
        {"perspective",
         "w",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.stages.interpolate_perspective =
                 [](BatchRuns runs, const FragmentBatch& batch, PerspectivePlanes& planes) {
                     ReferenceStages.interpolate_perspective(runs, batch, planes);
                     if (const auto lane = fault_lane(batch)) planes.w[*lane] *= 1.25f;
                 };
         }},
        {"colors",
         "primary",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.stages.interpolate_colors = [](const InterpolantLayout& layout,
                                                    BatchRuns runs,
                                                    const PerspectivePlanes& planes,
                                                    FragmentBatch& batch) {
                 ReferenceStages.interpolate_colors(layout, runs, planes, batch);
                 if (const auto lane = fault_lane(batch)) batch.primary.g[*lane] ^= 1;
             };
         }},
        {"tex_coords 0",
         "t",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.stages.interpolate_tex_coords = [](const InterpolantLayout& layout,
                                                        unsigned unit,
                                                        BatchRuns runs,
                                                        const PerspectivePlanes& planes,
                                                        const FragmentBatch& batch,
                                                        TexCoordPlanes& result) {
                 ReferenceStages.interpolate_tex_coords(layout, unit, runs, planes, batch, result);
                 if (const auto lane = fault_lane(batch)) result.t[*lane] += 0.125f;
             };
         }},
        {"depth",
         "sample_depth[1]",
         true,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.stages.interpolate_sample_depths =
                 [](BatchRuns runs, const FragmentBatch& batch, SampleDepths& depths) {
                     ReferenceStages.interpolate_sample_depths(runs, batch, depths);
                     if (const auto lane = fault_lane(batch)) depths.of[1][*lane] ^= 1;
                 };
         }},
        {"tex_coords 0",
         "s",
         false,
         " lane 1 ",
         [](FaultyBackend& backend) {
             backend.stages.interpolate_directions = [](const InterpolantLayout& layout,
                                                        unsigned unit,
                                                        BatchRuns runs,
                                                        const PerspectivePlanes& planes,
                                                        const FragmentBatch& batch,
                                                        TexCoordPlanes& result) {
                 ReferenceStages.interpolate_directions(layout, unit, runs, planes, batch, result);
                 for (unsigned lane = FaultLane; lane < batch.lanes(); lane += 4)
                     result.s[lane] += 0.5f;
             };
         }},
        {"antialias",
         "coverage",
         false,
         " lane 1 ",
         [](FaultyBackend& backend) {
             backend.stages.smooth_block =
                 [](const SetupRecord& record, int x, int y, BlockAntialias& antialias) {
                     const BlockMask mask = ReferenceStages.smooth_block(record, x, y, antialias);
                     for (std::size_t bit = FaultLane; bit < antialias.size(); bit += 4)
                         antialias[bit] ^= 1;
                     return mask;
                 };
         }},
        {"environment 0",
         "color",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.fragment.run_environment =
                 [](const EnvironmentProgram& program, unsigned unit, FragmentBatch& batch) {
                     ReferenceFragmentStages.run_environment(program, unit, batch);
                     if (const auto lane = fault_lane(batch)) batch.color.r[*lane] ^= 1;
                 };
         }},
        {"color_sum",
         "color",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.fragment.add_secondary = [](FragmentBatch& batch) {
                 ReferenceFragmentStages.add_secondary(batch);
                 if (const auto lane = fault_lane(batch)) batch.color.b[*lane] ^= 1;
             };
         }},
        {"fog",
         "color",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.fragment.apply_fog = [](const FogCurve& curve, FragmentBatch& batch) {
                 ReferenceFragmentStages.apply_fog(curve, batch);
                 if (const auto lane = fault_lane(batch)) batch.color.g[*lane] ^= 1;
             };
         }},
        {"antialias",
         "color",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.fragment.apply_coverage = [](FragmentBatch& batch) {
                 ReferenceFragmentStages.apply_coverage(batch);
                 if (const auto lane = fault_lane(batch)) batch.color.a[*lane] ^= 1;
             };
         }},
        {"alpha_test",
         "passed",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.fragment.alpha_test = [](const FragmentControl& control,
                                              const FragmentBatch& batch) {
                 FragmentMask mask = ReferenceFragmentStages.alpha_test(control, batch);
                 if (const auto lane = fault_lane(batch))
                     mask.words[*lane / 64] &= ~(std::uint64_t{1} << (*lane % 64));
                 return mask;
             };
         }},
        {"stencil_depth",
         "passed_depth",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.fragment.test_depth_target = [](const StencilDepthState& state,
                                                     const Surface& surface,
                                                     const FragmentBatch& batch,
                                                     std::span<std::byte> memory) {
                 StencilDepthFates fates =
                     ReferenceFragmentStages.test_depth_target(state, surface, batch, memory);
                 if (const auto lane = fault_lane(batch))
                     fates.after_depth.words[*lane / 64] &= ~(std::uint64_t{1} << (*lane % 64));
                 return fates;
             };
         }},
        {"color_write 0",
         "stored",
         false,
         FaultPlace,
         [](FaultyBackend& backend) {
             backend.fragment.write_color = [](const ColorStage& stage,
                                               const ColorTarget& target,
                                               const FragmentBatch& batch,
                                               std::span<std::byte> memory) {
                 ReferenceFragmentStages.write_color(stage, target, batch, memory);
                 if (!fault_lane(batch)) return;
                 memory[target.surface.address + FaultPixelY * target.surface.stride +
                        4 * FaultPixelX] ^= std::byte{1};
             };
         }},
        {"texture 0",
         "sample",
         false,
         " lane 1 ",
         [](FaultyBackend& backend) {
             backend.stages.sample = [](const TextureUnit& unit,
                                        TexCoordPlanes& coordinates,
                                        const SampleQuads& quads,
                                        ColorPlanes& colors,
                                        TexelFootprints* footprints) {
                 ReferenceStages.sample(unit, coordinates, quads, colors, footprints);
                 colors.r[FaultLane] ^= 4; // of each batch's first quad
             };
         }},
    };
    return faults;
}

} // namespace ffgpu::test
