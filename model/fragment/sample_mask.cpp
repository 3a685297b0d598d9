#include "model/fragment/sample_mask.h"

namespace ffgpu {
namespace {

void cover_by_alpha(FragmentBatch& batch) {
    SampleMasks covered;
    for (unsigned lane = 0; lane < batch.lanes(); ++lane) {
        const unsigned samples = alpha_coverage(batch.color.a[lane],
                                                batch.x[lane / 4] + (lane & 1u),
                                                batch.y[lane / 4] + (lane >> 1 & 1u));
        for (unsigned i = 0; i < MaxSamples; ++i)
            covered[i].words[lane / 64] |= std::uint64_t{samples >> i & 1} << (lane % 64);
    }
    for (unsigned i = 0; i < MaxSamples; ++i)
        batch.samples[i] = batch.samples[i] & covered[i];
}

} // namespace

void apply_sample_mask(const Multisample& state, FragmentBatch& batch) {
    if (!state.enable) return;
    if (state.alpha_to_coverage) cover_by_alpha(batch);
    if (state.alpha_to_one) batch.color.a.fill(255);
    for (unsigned i = 0; i < MaxSamples; ++i)
        if ((state.sample_mask >> i & 1) == 0) batch.samples[i] = {};
    batch.live = any_sample(batch.samples);
}

} // namespace ffgpu
