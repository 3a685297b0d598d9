// StageTap: tells a stage probe what a tile renderer's stages did, from coverage to the texture
// units; from there on the fragment pipe does (model/fragment/fragment_tap.h). It reads what the
// stages left, and reckons what they do not leave by the scalar specifications.

#pragma once

#include "model/gpu/bin.h"
#include "model/gpu/sampling_log.h"
#include "model/packets/stage_probe.h"
#include "model/raster/interpolator.h"

#include <array>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ffgpu {

class StageTap {
public:
    StageTap(StageProbe& probe, const FragmentBatch& batch)
        : batch_(batch)
        , tap_{probe, {.fragments = &batch}} {}

    // The batch that the calls from here on are about.
    void begin(const BinCommand& command, std::span<const BatchRun> runs);

    void coverage();
    void depth() { tap_.probe.depth(tap_.batch); }
    void perspective(const PerspectivePlanes& planes);
    void colors(const InterpolantLayout& layout);
    void tex_coords(const InterpolantLayout& layout, unsigned unit, const TexCoordPlanes& result);
    void sampling(const TextureUnit& texture, unsigned unit, const TexCoordPlanes& coordinates);

    // For the fragment pipe.
    const ProbeTap& pipe() const { return tap_; }

private:
    void count_pieces();
    void plane_values(int first, unsigned count, std::span<probed::Lanes<double>> out) const;

    const FragmentBatch& batch_;
    ProbeTap tap_;
    FragmentMask covered_; // of the batch, before any test
    std::vector<probed::Run> runs_;
    std::vector<std::uint32_t> pieces_; // of each quad
    // Of an image in a tile: quads that came so far, by their place.
    std::map<std::pair<std::uint16_t, std::uint16_t>, std::uint32_t> image_quads_;
    std::array<std::uint32_t, 3> image_tile_{}; // draw, tile
    SamplingLog sampling_;
    probed::Coverage coverage_{};
    probed::Perspective perspective_{};
    probed::Colors colors_{};
    probed::TexCoords tex_coords_{};
};

} // namespace ffgpu
