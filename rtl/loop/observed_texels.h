// What the model's texture unit does with a batch, as the inputs of the units that do it in RTL.

#pragma once

#include "model/texture/coordinates.h"
#include "model/texture/depth_compare.h"
#include "model/texture/level_of_detail.h"
#include "model/texture/texture_unit.h"
#include "rtl/bundles/levels.h"
#include "rtl/bundles/texel.h"

#include <cstring>
#include <vector>

namespace ffgpu::rtl {

// A texel of a unit's image, to be decoded; the block is still to be read. BorderTexel as a
// coordinate: the border's colour.
inline TexelBlock
texel_block(const TextureUnit& unit, float r, unsigned x, unsigned y, unsigned layer) {
    const Sampler& sampler = unit.sampler;
    constexpr unsigned Border = TexelAccess::BorderTexel;
    TexelBlock block{.is_border = x == Border || y == Border || layer == Border,
                     .format = unit.format,
                     .srgb = unit.srgb,
                     .compare_enable = sampler.compare_enable,
                     .relation = sampler.compare,
                     .depth_mode = sampler.depth_mode,
                     .reference = reference_depth(r),
                     .x = static_cast<std::uint8_t>(x % 8),
                     .y = static_cast<std::uint8_t>(y % 4)};
    if (block.is_border)
        block.block[0] = format_info(unit.format).is_depth ? sampler.border_depth & 0xffffff
                                                           : sampler.border_color;
    return block;
}

class ObservedTexels final : public TexelObserver {
public:
    ObservedTexels(const TextureUnit& unit, const TexCoordPlanes& coordinates)
        : unit_(unit)
        , coordinates_(coordinates) {}

    std::vector<unsigned> quads;         // of the batch
    std::vector<QuadSampling> samplings; // theirs
    std::vector<TexelBlock> blocks;      // as many as the levels have texels, in their order
    std::vector<Rgba> colors;            // of the blocks
    std::vector<FilterLevel> levels;     // without texels
    std::vector<unsigned> lanes;         // of the batch, of each block

    void quad(unsigned quad, const QuadSampling& sampling) override {
        quads.push_back(quad);
        samplings.push_back(sampling);
    }
    void probe(unsigned lane, unsigned, const TexCoord&, const ProbeWeights&) override {
        lane_ = lane;
        last_probe_ = ++probe_ == samplings.back().probes;
        if (last_probe_) probe_ = 0;
        fine_ = true;
    }
    void level(const TexelAccess& access, const std::array<AxisTexels, 3>& axes) override {
        const QuadSampling& sampling = samplings.back();
        const auto weight = [&](unsigned axis) {
            const bool filters = (access.linear >> axis & 1) != 0;
            return static_cast<std::uint8_t>(filters ? axes[axis].weight : 0);
        };
        levels.push_back({.last_level = !fine_ || sampling.weight == 0,
                          .last_probe = last_probe_,
                          .probes = sampling.probes,
                          .level_weight = sampling.weight,
                          .weight_z = weight(2),
                          .weight_y = weight(1),
                          .weight_x = weight(0)});
        fine_ = false;
    }
    void read(unsigned, unsigned layer, unsigned x, unsigned y) override {
        blocks.push_back(texel_block(unit_, coordinates_.r[lane_], x, y, layer));
        lanes.push_back(lane_);
    }
    void texel(std::span<const std::byte> bytes, const Rgba& color) override {
        std::memcpy(blocks.back().block.data(), bytes.data(), bytes.size());
        colors.push_back(color);
    }

private:
    const TextureUnit& unit_;
    const TexCoordPlanes& coordinates_;
    unsigned lane_ = 0, probe_ = 0;
    bool last_probe_ = false, fine_ = true;
};

} // namespace ffgpu::rtl
