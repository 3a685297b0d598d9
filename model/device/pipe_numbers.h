// The fragment pipe of rtl/ in numbers: the latency of each unit in cycles, and how much its queues
// and its cache hold. The one place where they are written: rtl/ffgpu_registers_pkg.sv is printed
// with them, from which the units take their stages and depths, and the machine in time has them as
// its preset rtl_pipe.

#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

namespace ffgpu {

struct PipeNumber {
    std::string_view name;
    std::uint32_t value;
    std::string_view meaning;
};

inline constexpr std::array PipeNumbers{
    PipeNumber{"WalkerLatency", 1, "cycles: tile_walker, from a quad's place to its output"},
    PipeNumber{"DepthPlaneLatency", 2, "cycles"},
    PipeNumber{"AttributePlaneLatency", 2, "cycles"},
    PipeNumber{"PerspectiveLatency", 4, "cycles"},
    PipeNumber{"ReciprocalLatency", 6, "cycles"},
    PipeNumber{"LevelOfDetailLatency", 6, "cycles"},
    PipeNumber{"TexelAddressLatency", 9, "cycles"},
    PipeNumber{"TexelFetchLatency", 1, "cycles"},
    PipeNumber{"TexelCacheLatency", 2, "cycles, where the line is there"},
    PipeNumber{"TexelDecodeLatency", 2, "cycles"},
    PipeNumber{"FilterTreeLatency", 4, "cycles"},
    PipeNumber{"TextureEnvironmentLatency", 3, "cycles"},
    PipeNumber{"ColorSumLatency", 1, "cycles"},
    PipeNumber{"FogLatency", 6, "cycles"},
    PipeNumber{"ApplyCoverageLatency", 1, "cycles"},
    PipeNumber{"AlphaTestLatency", 1, "cycles"},
    PipeNumber{"QuadInterlockLatency", 1, "cycles"},
    PipeNumber{"StencilDepthLatency", 1, "cycles"},
    PipeNumber{"BlendLatency", 3, "cycles"},
    PipeNumber{"TargetWriteLatency", 1, "cycles: from a quad to its store's being offered"},
    PipeNumber{"FifoLatency", 1, "cycles: a queue or a register"},
    PipeNumber{"WalkedQuads", 4, "places: quads beside depth_plane"},
    PipeNumber{"DividedQuads", 8, "places: quads whose divisors are made"},
    PipeNumber{"PendingQuads", 16, "places: quads that wait for their samples"},
    PipeNumber{"TargetQuads", 16, "places: quads between the read of a target and the store"},
    PipeNumber{"TexelQueue", 32, "places: texels between tags and data"},
    PipeNumber{"CacheSetBits", 4, "of the texel cache's sets"},
    PipeNumber{"CacheWayBits", 2, "of its ways"},
    PipeNumber{"LineBits", 6, "of the bytes of a line"},
    PipeNumber{"FillBits", 3, "of lines on their way"}};

// In a constant it does not compile with a name that is none.
constexpr std::uint32_t pipe_number(std::string_view name) {
    for (const PipeNumber& number : PipeNumbers)
        if (number.name == name) return number.value;
    throw std::invalid_argument("no such number of the pipe");
}

} // namespace ffgpu
