// The fragment pipe behind the texture units: from samples to pixels.
//
//     early_depth_test   kills hidden fragments before they are textured, where nobody can tell
//     shade              texture environments, colour sum, fog, antialiasing coverage
//     write              alpha test, stencil and depth, blending or logic operation, masks, dither
//
// With several samples a pixel, sample_pipe.h carries out the first and the last for each sample.
//
// A stage is a file: its scalar functions are its specification, its _simd.cpp file computes the
// same bits. The pipe runs those of the table that it was compiled with (fragment_stages.h).

#pragma once

#include "model/fragment/fragment_stages.h"
#include "model/fragment/quad_access.h"
#include "model/packets/draw_state.h"
#include "model/packets/fragment_batch.h"
#include "model/packets/stage_probe.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>

namespace ffgpu {

// What a draw needs, compiled once from its registers. Targets that do not fit into memory are
// left out: registers may come from a file. Live fragments lie within every target that is there:
// the rasterizer's clip is the scissor cut to the targets.
struct FragmentPipe {
    const FragmentStages* stages = &FastFragmentStages;
    std::shared_ptr<const Registers> registers;
    std::span<std::byte> memory;

    std::uint8_t samples = 1; // of a pixel of the targets
    bool early_depth = false; // early_depth_test() does what write() would do later.
    bool antialias = false;
    // Nothing changes colours, tests their alpha or mixes them with others on their way from the
    // primitives to the targets, which hold them as rgba8.
    bool keeps_colors = false;
    // false: write() leaves the colours of the targets as they are.
    bool stores_colors = true;
    EnvironmentProgram environments;
    FogCurve fog;
    StencilDepthState stencil_depth;
    Surface depth_target;
    ColorStage color_stage;
    std::array<ColorTarget, ColorTargets> color_targets;
};

FragmentPipe compile_fragment_pipe(const DrawState& state,
                                   std::span<std::byte> memory,
                                   const FragmentStages& stages = FastFragmentStages);

// Each of the three tells a probe what its stages did, if there is a tap.

// Clears bits of `live`; writes depth if the draw does. Does nothing for a pipe that tests late.
void early_depth_test(const FragmentPipe& pipe,
                      FragmentBatch& batch,
                      const ProbeTap* tap = nullptr);

// From primary, secondary, texture samples, fog coordinate and antialias to `color`, for every
// lane.
void shade(const FragmentPipe& pipe, FragmentBatch& batch, const ProbeTap* tap = nullptr);

// The fragments left after each test; the tests of a stage that is off let all pass. A fragment of
// multisampled targets is left as long as one of its samples is.
struct FragmentFates {
    FragmentMask after_coverage, after_alpha, after_stencil, after_depth;
    SampleMasks tested; // multisampled: the samples of after_alpha that are left for the tests
};

// Only pixels of live fragments are touched, of several samples those that the fragment covers.
// `live` and `samples` end as what passed all tests: what occlusion queries count.
void write(const FragmentPipe& pipe,
           FragmentBatch& batch,
           FragmentFates& fates,
           const ProbeTap* tap = nullptr);

// What shade() and write() do where the pipe keeps_colors, from the primitives' colours as words.
void write_kept(const FragmentPipe& pipe,
                const LaneWords& colors,
                FragmentBatch& batch,
                FragmentFates& fates);

} // namespace ffgpu
