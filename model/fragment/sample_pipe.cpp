#include "model/fragment/sample_pipe.h"

#include "model/fragment/fragment_tap.h"
#include "model/fragment/sample_mask.h"

namespace ffgpu {
namespace {

// Makes sample i's fragments the live ones, and its depths theirs.
void select_sample(unsigned i, FragmentBatch& batch) {
    batch.live = batch.samples[i];
    if (batch.sample_depths) batch.depth = batch.sample_depths->of[i];
}

void mask_samples(const FragmentPipe& pipe, FragmentBatch& batch, const ProbeTap* tap) {
    const Multisample& state = pipe.registers->multisample;
    if (!tap || !state.enable) return apply_sample_mask(state, batch);
    const SampleMasks before = batch.samples;
    apply_sample_mask(state, batch);
    tap->probe.sample_mask(tap->batch, before);
}

} // namespace

void early_depth_test_samples(const FragmentPipe& pipe, FragmentBatch& batch, const ProbeTap* tap) {
    if (!pipe.early_depth) return;
    for (unsigned i = 0; i < MaxSamples; ++i) {
        select_sample(i, batch);
        batch.samples[i] = run_depth_test(pipe, i, batch, tap).after_depth;
    }
    batch.live = any_sample(batch.samples);
}

void write_samples(const FragmentPipe& pipe,
                   FragmentBatch& batch,
                   FragmentFates& fates,
                   const ProbeTap* tap) {
    mask_samples(pipe, batch, tap);
    fates.after_coverage = batch.live;
    fates.after_alpha = run_alpha_test(pipe, batch, tap);
    SampleMasks after_stencil;
    for (unsigned i = 0; i < MaxSamples; ++i) {
        fates.tested[i] = batch.samples[i] = after_stencil[i] =
            batch.samples[i] & fates.after_alpha;
        select_sample(i, batch);
        if (!pipe.early_depth) {
            const StencilDepthFates tested = run_depth_test(pipe, i, batch, tap);
            after_stencil[i] = tested.after_stencil;
            batch.live = batch.samples[i] = tested.after_depth;
        }
        run_color_write(pipe, i, batch, tap);
    }
    fates.after_stencil = any_sample(after_stencil);
    batch.live = fates.after_depth = any_sample(batch.samples);
}

} // namespace ffgpu
