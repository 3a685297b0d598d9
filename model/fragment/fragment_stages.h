// FragmentStages: the stages of the fragment pipe in their order, as batch functions. There are two
// tables of them: vectors, and the scalar specifications one lane after the other, which give the
// same bits. What a stage does is in the header of its name.
//
// Between them stand what has one form: the sample mask (sample_mask.h) and the pipe itself.

#pragma once

#include "model/fragment/color_target.h"
#include "model/fragment/fog.h"
#include "model/fragment/stencil_depth.h"
#include "model/fragment/texture_environment.h"
#include "model/packets/fragment_batch.h"

#include <cstddef>
#include <span>

namespace ffgpu {

struct FragmentStages {
    void (*run_environment)(const EnvironmentProgram&, unsigned i, FragmentBatch&);
    void (*add_secondary)(FragmentBatch&);
    void (*apply_fog)(const FogCurve&, FragmentBatch&);
    void (*apply_coverage)(FragmentBatch&);
    FragmentMask (*alpha_test)(const FragmentControl&, const FragmentBatch&);
    StencilDepthFates (*test_depth_target)(const StencilDepthState&,
                                           const Surface&,
                                           const FragmentBatch&,
                                           std::span<std::byte> memory);
    void (*write_color)(const ColorStage&,
                        const ColorTarget&,
                        const FragmentBatch&,
                        std::span<std::byte> memory);
};

extern const FragmentStages FastFragmentStages, ReferenceFragmentStages;

} // namespace ffgpu
