// StageAccount: what the stages of the functional GPU did, as entries of an account.

#pragma once

#include "model/packets/stage_probe.h"
#include "tools/diff/account_sink.h"

namespace ffgpu::tools {

class StageAccount final : public StageProbe {
public:
    explicit StageAccount(AccountSink& sink)
        : sink_(sink) {}

    void set_up(const probed::SetUp& told) override;
    void coverage(const probed::Batch& batch, const probed::Coverage& told) override;
    void depth(const probed::Batch& batch) override;
    void perspective(const probed::Batch& batch, const probed::Perspective& told) override;
    void colors(const probed::Batch& batch, const probed::Colors& told) override;
    void tex_coords(const probed::Batch& batch, const probed::TexCoords& told) override;
    void sampling(const probed::Batch& batch, const probed::Sampling& told) override;
    void environment(const probed::Batch& batch, const probed::Environment& told) override;
    void color_sum(const probed::Batch& batch, const ColorPlanes& before) override;
    void fog(const probed::Batch& batch, const probed::Fog& told) override;
    void antialias(const probed::Batch& batch, const ColorPlanes& before) override;
    void sample_mask(const probed::Batch& batch, const SampleMasks& before) override;
    void alpha_test(const probed::Batch& batch, const probed::Test& told) override;
    void stencil_depth(const probed::Batch& batch, const probed::StencilDepth& told) override;
    void color_write(const probed::Batch& batch, const probed::ColorWrite& told) override;

private:
    // Calls fill(lane) for each lane of the mask, between the entry's begin and end.
    template <class Fill>
    void entries(AccountPart part,
                 const probed::Batch& batch,
                 const FragmentMask& lanes,
                 Fill fill,
                 unsigned sample = 0);
    void shaded(AccountPart part, const probed::Batch& batch, const ColorPlanes& before);
    void quad_levels(const probed::QuadLevels& quad);
    void level_filter(const probed::LevelFilter& filter, int index);

    AccountSink& sink_;
};

} // namespace ffgpu::tools
