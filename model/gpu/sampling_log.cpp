#include "model/gpu/sampling_log.h"

#include "model/base/check.h"
#include "model/texture/coordinates.h"
#include "model/texture/level_of_detail.h"

#include <algorithm>
#include <bit>

namespace ffgpu {

probed::Sampling SamplingLog::run(const TextureUnit& unit,
                                  const TexCoordPlanes& coordinates,
                                  const SampleQuads& quads) {
    quads_.clear();
    probes_.clear();
    levels_.clear();
    sample_scalar(unit, coordinates, quads, colors_, nullptr, this);
    return {
        .coordinates = &coordinates, .quads = quads_, .probes = probes_, .level_filters = levels_};
}

void SamplingLog::quad(unsigned quad, const QuadSampling& sampling) {
    quads_.push_back({.quad = static_cast<std::uint8_t>(quad),
                      .probes = sampling.probes,
                      .level = sampling.level,
                      .next_level = sampling.next_level,
                      .weight = sampling.weight,
                      .linear = sampling.linear,
                      .step_x = sampling.steps.x,
                      .step_y = sampling.steps.y,
                      .footprint_x = std::bit_cast<float>(sampling.footprint.x),
                      .footprint_y = std::bit_cast<float>(sampling.footprint.y),
                      .lambda = sampling.lambda});
}

void SamplingLog::probe(unsigned lane,
                        unsigned face,
                        const TexCoord& at,
                        const ProbeWeights& weights) {
    const bool another = !probes_.empty() && probes_.back().lane == lane;
    const unsigned number = another ? probes_.back().probe + 1u : 0u;
    probes_.push_back({.lane = static_cast<std::uint16_t>(lane),
                       .probe = static_cast<std::uint8_t>(number),
                       .face = static_cast<std::uint8_t>(face),
                       .coordinates = {at.s, at.t, at.r},
                       .weight = weights.probe,
                       .next_level = weights.next_level,
                       .level_filter = static_cast<std::uint32_t>(levels_.size())});
}

void SamplingLog::level(const TexelAccess& access, const std::array<AxisTexels, 3>& axes) {
    probed::LevelFilter& told = levels_.emplace_back();
    told.access = access;
    told.probe = probes_.back().probe;
    ++probes_.back().level_filters;
    for (unsigned axis = 0; axis < axes.size(); ++axis)
        told.weight[axis] = static_cast<std::uint8_t>(axes[axis].weight);
}

void SamplingLog::read(unsigned /*level*/, unsigned layer, unsigned x, unsigned y) {
    probed::LevelFilter& told = levels_.back();
    check(told.texel_count < told.texels.size(), "a filter reads eight texels at most");
    probed::Texel& texel = told.texels[told.texel_count++];
    texel.x = static_cast<std::uint16_t>(x);
    texel.y = static_cast<std::uint16_t>(y);
    texel.layer = static_cast<std::uint16_t>(layer);
}

void SamplingLog::texel(std::span<const std::byte> stored,
                        const std::array<std::uint8_t, 4>& color) {
    probed::LevelFilter& told = levels_.back();
    probed::Texel& texel = told.texels[told.texel_count - 1u];
    check(stored.size() <= texel.stored.size(), "a texel or block has 16 bytes at most");
    texel.bytes = static_cast<std::uint8_t>(stored.size());
    std::copy(stored.begin(), stored.end(), texel.stored.begin());
    texel.color = color;
}

void SamplingLog::texel_weights(const std::array<std::int32_t, 4>& weights) {
    levels_.back().texel_weights = weights;
}

void SamplingLog::filtered(unsigned axis, const std::array<std::uint8_t, 4>& color) {
    probed::LevelFilter& told = levels_.back();
    if (axis == 0)
        told.along_x[told.along_x_count++] = color;
    else if (axis == 1)
        told.along_y[told.along_y_count++] = color;
    else if (axis == 2)
        told.color = color;
    else
        probes_.back().color = color;
}

} // namespace ffgpu
