#include "model/fragment/sample_pipe.h"

#include "model/fragment/alpha_test.h"
#include "model/fragment/depth_target.h"
#include "model/fragment/sample_mask.h"

namespace ffgpu {
namespace {

// Makes sample i's fragments the live ones, and its depths theirs.
void select_sample(unsigned i, FragmentBatch& batch) {
    batch.live = batch.samples[i];
    if (batch.sample_depths) batch.depth = batch.sample_depths->of[i];
}

StencilDepthFates test_sample(const FragmentPipe& pipe, unsigned i, FragmentBatch& batch) {
    return test_depth_target(pipe.stencil_depth, pipe.depth_target.plane(i), batch, pipe.memory);
}

void write_sample_color(const FragmentPipe& pipe, unsigned i, const FragmentBatch& batch) {
    if (!batch.live.any()) return;
    for (const ColorTarget& target : pipe.color_targets)
        write_color(
            pipe.color_stage, {target.surface.plane(i), target.write_mask}, batch, pipe.memory);
}

} // namespace

void early_depth_test_samples(const FragmentPipe& pipe, FragmentBatch& batch) {
    if (!pipe.early_depth) return;
    for (unsigned i = 0; i < MaxSamples; ++i) {
        select_sample(i, batch);
        batch.samples[i] = test_sample(pipe, i, batch).after_depth;
    }
    batch.live = any_sample(batch.samples);
}

void write_samples(const FragmentPipe& pipe, FragmentBatch& batch, FragmentFates& fates) {
    apply_sample_mask(pipe.registers->multisample, batch);
    fates.after_coverage = batch.live;
    fates.after_alpha = alpha_test(pipe.registers->fragment, batch);
    SampleMasks after_stencil;
    for (unsigned i = 0; i < MaxSamples; ++i) {
        batch.samples[i] = after_stencil[i] = batch.samples[i] & fates.after_alpha;
        select_sample(i, batch);
        if (!pipe.early_depth) {
            const StencilDepthFates tested = test_sample(pipe, i, batch);
            after_stencil[i] = tested.after_stencil;
            batch.live = batch.samples[i] = tested.after_depth;
        }
        write_sample_color(pipe, i, batch);
    }
    fates.after_stencil = any_sample(after_stencil);
    batch.live = fates.after_depth = any_sample(batch.samples);
}

} // namespace ffgpu
