// The places of what a draw reads and writes, asked for in the order in which they are handed out.

#pragma once

#include "model/work/address_map.h"
#include "model/work/config.h"

namespace ffgpu::work {

// Calls out.texture(unit, lines), out.depth(place), out.color(target, place); what they are given
// holds as AddressMap says.
template <class Out>
void place_draw(const Registers& state, const WorkConfig& config, AddressMap& addresses, Out& out) {
    for (unsigned unit = 0; unit < TextureUnits; ++unit)
        if (state.images[unit].shape.kind != TextureKind::None)
            out.texture(unit, addresses.texture_lines(state.images[unit]));
    if (state.targets.depth.format != Format::None)
        out.depth(addresses.surface(state.targets.depth, config.depth_cache));
    for (std::uint8_t i = 0; i < ColorTargets; ++i)
        if (state.targets.color[i].format != Format::None)
            out.color(i, addresses.surface(state.targets.color[i], config.color_cache));
}

} // namespace ffgpu::work
