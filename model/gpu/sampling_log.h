// SamplingLog: what the scalar texture unit does for one batch, kept for a stage probe.

#pragma once

#include "model/packets/stage_probe.h"
#include "model/texture/texture_unit.h"

#include <vector>

namespace ffgpu {

class SamplingLog final : private TexelObserver {
public:
    // Samples the quads' live fragments once more, by the specification. What is told lives until
    // the next call.
    probed::Sampling
    run(const TextureUnit& unit, const TexCoordPlanes& coordinates, const SampleQuads& quads);

private:
    void quad(unsigned quad, const QuadSampling& sampling) override;
    void
    probe(unsigned lane, unsigned face, const TexCoord& at, const ProbeWeights& weights) override;
    void level(const TexelAccess& access, const std::array<AxisTexels, 3>& axes) override;
    void read(unsigned level, unsigned layer, unsigned x, unsigned y) override;
    void texel(std::span<const std::byte> stored,
               const std::array<std::uint8_t, 4>& color) override;
    void texel_weights(const std::array<std::int32_t, 4>& weights) override;
    void filtered(unsigned axis, const std::array<std::uint8_t, 4>& color) override;

    std::vector<probed::QuadLevels> quads_;
    std::vector<probed::Probe> probes_;
    std::vector<probed::LevelFilter> levels_;
    ColorPlanes colors_{};
};

} // namespace ffgpu
