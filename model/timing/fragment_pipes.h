// Which of the parallel fragment pipes a quad takes: one for each quad that the rasterizer makes a
// cycle. A pixel always goes through the same pipe, so that its fragments stay in order.

#pragma once

#include "model/timing/config.h"
#include "model/timing/tokens.h"

namespace ffgpu::timing {

inline std::uint32_t fragment_pipe(const TimingConfig& config, const PreparedQuad& quad) {
    const std::uint32_t width = config.fragment.distribution_width;
    const bool tiles = config.fragment.distribution == Distribution::Tiles;
    const std::uint32_t place = quad.y / width + (tiles ? quad.x / width : 0);
    return place % config.raster.quads_per_cycle;
}

} // namespace ffgpu::timing
