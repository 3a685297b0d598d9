// What a scene writes to its targets, in the order in which the machine writes it.

#pragma once

#include "model/work/prepared_work.h"

namespace ffgpu::work {

// Calls quad(const PreparedQuad&) for each quad, and fill(const SurfaceFill&) for the clears that
// are part of a tile-based machine's scene, bin by bin between the quads of the bin.
template <class Fill, class Quad>
void for_each_write(const PreparedScene& scene, Fill&& fill, Quad&& quad) {
    const std::vector<TileFill>& fills = scene.tiles.fills;
    auto next = fills.begin();
    for (std::uint32_t i = 0; i < scene.quads.size(); ++i) {
        for (; next != fills.end() && next->quad <= i; ++next)
            fill(next->fill);
        quad(scene.quads[i]);
    }
    for (; next != fills.end(); ++next)
        fill(next->fill);
}

} // namespace ffgpu::work
