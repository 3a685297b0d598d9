// Views: pictures of a frame other than the one that is shown. docs/command_line.md tells of each.

#pragma once

#include "model/device/registers.h"
#include "tools/heatmap/heat_map.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace ffgpu::tools {

enum class View : std::uint8_t {
    Wireframe,
    Depth,
    Stencil,
    Normals,
    TexCoord,
    Unlit,
    Untextured,
    BeforeFog,
    Count
};

// How a view comes about.
enum class ViewSource : std::uint8_t {
    Redrawn,        // the same commands with other registers, on a device of its own
    RedrawnOnBlack, // and what clears the colours makes them black
    Target,         // what the depth and stencil target holds at the frame's end
};

struct ViewInfo {
    std::string_view name;
    ViewSource source;
};
constexpr std::array<ViewInfo, static_cast<std::size_t>(View::Count)> ViewTable{{
    {"wireframe", ViewSource::RedrawnOnBlack},
    {"depth", ViewSource::Target},
    {"stencil", ViewSource::Target},
    {"normals", ViewSource::RedrawnOnBlack},
    {"texcoord", ViewSource::RedrawnOnBlack},
    {"unlit", ViewSource::Redrawn},
    {"untextured", ViewSource::Redrawn},
    {"before_fog", ViewSource::Redrawn},
}};
constexpr const ViewInfo& info(View view) {
    return ViewTable[static_cast<std::size_t>(view)];
}

// Two more names are heat maps.
struct WantedViews {
    std::set<View> views;
    std::set<HeatMap> heat_maps; // "level", "coverage"
};

// "depth,before-fog"; throws InputError for an unknown name, with the nearest one.
WantedViews parse_views(const std::string& names);
// All of them, so written.
std::string view_names();

// Where a view's own texture lies: of TexCoord, a texel's red is s and its green is t.
constexpr std::uint32_t ViewTextureSize = 256;
std::vector<std::byte> view_texture();

// The registers that a redrawn view draws with instead of these. `texture`: where view_texture()
// is.
Registers view_registers(View view, const Registers& registers, DeviceAddress texture);

} // namespace ffgpu::tools
