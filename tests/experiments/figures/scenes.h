// The work of the scenes of the texture-cache literature, by formula (analytic_scenes.h), and drawn
// by the functional GPU as one triangle; and the texels that a machine looks up of it.

#pragma once

#include "model/work/command_assembler.h"
#include "model/work/config.h"
#include "tests/timing/analytic_scenes.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace ffgpu::experiments {

using Work = std::vector<std::shared_ptr<const work::WholeCommand>>;

Work analytic(const timing::Scene& scene);

// Texel coordinates of level 0 and the depth w of a point of the screen, where a triangle shows a
// plane: exact at its corners, and so everywhere.
struct PlanePoint {
    double u = 0, v = 0, w = 1;
};
struct PlaneScene {
    unsigned width = 0, height = 0, texture_size = 0;
    double top = 0; // the first row drawn
    bool trilinear = false;
    std::function<PlanePoint(double x, double y)> at;
};

PlaneScene turned_plane(unsigned size, double degrees);
PlaneScene uniform_level_plane(unsigned size, double level);
// `forward`: how far the camera has gone, in repeats of the texture of 256.
PlaneScene floor_plane(unsigned texture_size, double forward = 0);
Work rasterized(const PlaneScene& scene);

// Both ways to the same scene.
struct BothWays {
    Work formula, drawn;
};
const BothWays& flat_scene();              // one texel a pixel
const BothWays& turned_scene(int degrees); // the same, turned
const BothWays& floor_scene(unsigned texture_size);

struct TexelStream {
    std::vector<std::uint64_t> lines; // looked up, in order
    std::uint64_t reads = 0;          // of texels
    std::uint64_t fragments = 0;

    double misses(std::uint32_t sets, std::uint32_t ways) const;
    double miss_percent(std::uint32_t sets, std::uint32_t ways) const;
};
TexelStream texel_stream(const Work& work, const work::WorkConfig& config);

} // namespace ffgpu::experiments
