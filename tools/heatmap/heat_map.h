// The heat maps there are: pictures of numbers, a number a pixel. docs/command_line.md tells of
// each.

#pragma once

#include "model/timing/resource.h"

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace ffgpu::tools {

enum class HeatMap : std::uint8_t {
    Overdraw,
    Covered,
    DepthKilled,
    StencilKilled,
    AlphaKilled,
    QuadLanes,
    Level,
    Texture,
    TextureMisses,
    Cycles,
    StallCause,
    DepthBlocks,
    ColorBlocks,
    Count
};

struct HeatMapInfo {
    std::string_view name, unit;
    double full_scale; // the value at the ramp's hot end; 0: what one pixel in 200 exceeds
    bool needs_timing;
    std::span<const std::string_view> names{}; // what 1, 2 ... stand for; empty: it is a quantity
};
constexpr std::array<HeatMapInfo, static_cast<std::size_t>(HeatMap::Count)> HeatMapTable{{
    {"overdraw", "fragments written", 8, false},
    {"covered", "fragments covered", 8, false},
    {"depth_killed", "fragments", 8, false},
    {"stencil_killed", "fragments", 8, false},
    {"alpha_killed", "fragments", 8, false},
    {"quad_lanes", "fragments a quad", 4, false},
    {"level", "1 + level", 8, false},
    {"texture", "number", 0, false},
    {"texture_misses", "misses a quad", 16, true},
    {"cycles", "cycles a quad", 32, true},
    {"stall_cause", "what its cycles waited for", 0, true, timing::ResourceNames},
    {"depth_blocks", "bytes a block", 64, true},
    {"color_blocks", "bytes a block", 64, true},
}};
constexpr const HeatMapInfo& info(HeatMap map) {
    return HeatMapTable[static_cast<std::size_t>(map)];
}

// "overdraw,level" -> the maps. Throws InputError for an unknown name, with the nearest one.
std::set<HeatMap> parse_heat_maps(const std::string& names);
// All of them, so written.
std::string heat_map_names();

} // namespace ffgpu::tools
