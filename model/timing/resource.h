// Resource: what a machine can wait for.

#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

enum class Resource : std::uint8_t {
    Host,
    CommandProcessor,
    VertexFetch,
    Geometry,
    Clip,
    Setup,
    Binner,
    ParameterFetch,
    TileMemory,
    Raster,
    Depth,
    Texture,
    TexelL2,
    Fragment,
    Color,
    MemoryBandwidth, // its buses, rows and queues
    MemoryLatency,   // nothing holds up what is on its way
    Links,           // all work is on its way from one unit to the next
    Interpolator,    // of machines that have one
    Count
};
inline constexpr std::size_t Resources = static_cast<std::size_t>(Resource::Count);
inline constexpr std::array<std::string_view, Resources> ResourceNames{"host",
                                                                       "command_processor",
                                                                       "vertex_fetch",
                                                                       "geometry",
                                                                       "clip",
                                                                       "setup",
                                                                       "binner",
                                                                       "parameter_fetch",
                                                                       "tile_memory",
                                                                       "raster",
                                                                       "depth",
                                                                       "texture",
                                                                       "texel_l2",
                                                                       "fragment",
                                                                       "color",
                                                                       "memory_bandwidth",
                                                                       "memory_latency",
                                                                       "links",
                                                                       "interpolator"};

// Cycles by what they were waited for.
using WaitedCycles = std::array<std::uint64_t, Resources>;

} // namespace ffgpu::timing
