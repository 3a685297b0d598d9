// The preset rtl_pipe: the machine in time as the fragment pipe of rtl/ is built. Latencies and
// depths are those of model/device/pipe_numbers.h; docs/rtl_cycles.md has the reasons at length.

#pragma once

#include "model/device/pipe_numbers.h"
#include "model/timing/presets.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace ffgpu::timing {

// A number as the text of a setting.
template <std::uint32_t Value>
struct Digits {
    static constexpr std::size_t Count = [] {
        std::size_t count = 1;
        for (std::uint32_t rest = Value; rest >= 10; rest /= 10)
            ++count;
        return count;
    }();
    static constexpr std::array<char, Count> Text = [] {
        std::array<char, Count> text{};
        std::uint32_t rest = Value;
        for (std::size_t i = Count; i-- > 0; rest /= 10)
            text[i] = static_cast<char>('0' + rest % 10);
        return text;
    }();
};
template <std::uint32_t Value>
inline constexpr std::string_view Text{Digits<Value>::Text.data(), Digits<Value>::Count};

namespace rtl_pipe {

inline constexpr std::uint32_t Fifo = pipe_number("FifoLatency");

// From a quad's place in the walk to the divisors, which take it a cycle before its values.
inline constexpr std::uint32_t ToInterpolator =
    pipe_number("WalkerLatency") + pipe_number("DepthPlaneLatency");
inline constexpr std::uint32_t Values =
    pipe_number("AttributePlaneLatency") + pipe_number("PerspectiveLatency");
inline constexpr std::uint32_t Divide = Values + pipe_number("ReciprocalLatency") + Fifo;
// From tags to the filter's sample and the quad's leaving, less the cycle in which its data are
// read and the one in which it goes on, and the one in which the sequencer takes the request.
inline constexpr std::uint32_t Sample =
    pipe_number("LevelOfDetailLatency") + pipe_number("TexelAddressLatency") +
    pipe_number("TexelFetchLatency") + pipe_number("TexelCacheLatency") +
    pipe_number("TexelDecodeLatency") + pipe_number("FilterTreeLatency") + Fifo - 2;
inline constexpr std::uint32_t Shading =
    pipe_number("ColorSumLatency") + pipe_number("FogLatency") +
    pipe_number("ApplyCoverageLatency") + pipe_number("AlphaTestLatency") +
    pipe_number("QuadInterlockLatency");
inline constexpr std::uint32_t ToColor =
    pipe_number("StencilDepthLatency") + pipe_number("QuadInterlockLatency");
inline constexpr std::uint32_t DepthStore =
    pipe_number("StencilDepthLatency") + pipe_number("TargetWriteLatency") + 1;
inline constexpr std::uint32_t ColorStore =
    pipe_number("BlendLatency") + pipe_number("TargetWriteLatency") + 1;
inline constexpr std::uint32_t EnvironmentRound = pipe_number("TextureEnvironmentLatency") + 1;

inline constexpr std::string_view Rtl = "rtl";
inline constexpr std::string_view Host = "the host's part: it does not wait";
inline constexpr std::string_view NoCache = "every quad reads and stores";
inline constexpr std::string_view Pixels = "a read is a quad's pixels";

inline constexpr std::array Settings{
    PresetSetting{"host.bytes_per_cycle", "0", Rtl, Host},
    PresetSetting{"command_processor.draw_cycles", "1", Rtl, Host},
    PresetSetting{
        "command_processor.drains", "true", Rtl, "a draw is drawn when the one before has ended"},
    PresetSetting{"vertex.vertices_per_cycle", "16", Rtl, Host},
    PresetSetting{"vertex.units", "16", Rtl, Host},
    PresetSetting{"vertex.order_entries", "256", Rtl, Host},
    PresetSetting{"vertex.transform_cycles", "1", Rtl, Host},
    PresetSetting{"vertex.light_cycles", "0", Rtl, Host},
    PresetSetting{"vertex.fetch_queue", "256", Rtl, Host},
    PresetSetting{"vertex.index_queue", "256", Rtl, Host},
    PresetSetting{"vertex.outstanding_lines", "1024", Rtl, Host},
    PresetSetting{"vertex.latency", "1", Rtl, Host},
    PresetSetting{"clip.plane_cycles", "0", Rtl, Host},
    PresetSetting{"setup.triangle_cycles", "1", Rtl, "a record a cycle"},
    PresetSetting{"setup.plane_cycles", "1", Rtl, "record_store: a plane a cycle"},
    PresetSetting{"setup.queue", "1", Rtl, "the next primitive's planes are written ahead"},
    PresetSetting{"raster.traversal", "nested", Rtl, "tile_sequence: tiles; tile_walker: blocks"},
    PresetSetting{"raster.tile_width", "8", Rtl, "tile_walker's blocks"},
    PresetSetting{"raster.outer_tile_width", "32", Rtl, "tile_sequence's tiles"},
    PresetSetting{"raster.walk", "tiles", Rtl, "all blocks of a tile; all quads of one touched"},
    PresetSetting{"raster.piece_cycles", "1", Rtl, "tile_sequence takes the record"},
    PresetSetting{"raster.latency", Text<ToInterpolator>, Rtl, "tile_walker, depth_plane"},
    PresetSetting{"raster.queue", "2", Rtl, "registers: tile_walker's, depth_plane's"},
    PresetSetting{"interpolator.value_cycles", "1", Rtl, "attribute_pass: a plane a cycle"},
    PresetSetting{"interpolator.divide_latency",
                  Text<Divide>,
                  Rtl,
                  "divisor_pass: attribute_plane, perspective, reciprocal, a queue"},
    PresetSetting{"interpolator.divide_queue",
                  Text<pipe_number("DividedQuads")>,
                  Rtl,
                  "divisor_pass: quads beside the divisors"},
    PresetSetting{"interpolator.latency", Text<Values>, Rtl, "attribute_plane, perspective"},
    PresetSetting{"interpolator.value_places",
                  Text<Values + 1>,
                  Rtl,
                  "a value in each stage of attribute_plane and perspective; one that leaves"},
    PresetSetting{"texture.request_queue",
                  Text<pipe_number("LevelOfDetailLatency")>,
                  Rtl,
                  "level_of_detail: a request in each stage"},
    PresetSetting{"texture.sample_queue",
                  Text<pipe_number("TexelAddressLatency") - 1>,
                  Rtl,
                  "texel_address: a sample in each stage behind texel_sequence"},
    PresetSetting{"texture.rate", "texels", Rtl, "texel_fetch: a texel a cycle"},
    PresetSetting{
        "texture.texel_queue", Text<pipe_number("TexelQueue")>, Rtl, "texel_cache's queue"},
    PresetSetting{"texture.latency",
                  Text<Sample>,
                  Rtl,
                  "level_of_detail, texel_address, texel_fetch, texel_cache, texel_decode, "
                  "filter_tree, a queue; less the cycles of the sequencer and of handing on"},
    PresetSetting{"texel_cache.sets", Text<1u << pipe_number("CacheSetBits")>, Rtl, "texel_cache"},
    PresetSetting{"texel_cache.ways", Text<1u << pipe_number("CacheWayBits")>, Rtl, "texel_cache"},
    PresetSetting{"texel_cache.line_bytes", Text<1u << pipe_number("LineBits")>, Rtl, "a line"},
    PresetSetting{"texel_cache.layout", "linear", Rtl, "images as the device keeps them"},
    PresetSetting{"texel_cache.lookups_per_cycle", "8", Rtl, "a texel's line is found at once"},
    PresetSetting{"texel_cache.outstanding_lines",
                  Text<1u << pipe_number("FillBits")>,
                  Rtl,
                  "texel_cache: fills on their way"},
    PresetSetting{
        "texel_cache.forgets", "true", Rtl, "textures may have changed: invalidate_i is set"},
    PresetSetting{"fragment.pipe_queue",
                  Text<pipe_number("PendingQuads")>,
                  Rtl,
                  "fragment_pipe: quads that wait for samples"},
    PresetSetting{"fragment.queue", "2", Rtl, "registers"},
    PresetSetting{"fragment.entry_cycles", "1", Rtl, "environment_loop: a cycle for the quad"},
    PresetSetting{"fragment.combiner_cycles",
                  Text<EnvironmentRound>,
                  Rtl,
                  "environment_loop: texture_environment, and the way back"},
    PresetSetting{"fragment.latency",
                  Text<Shading>,
                  Rtl,
                  "color_sum, fog, apply_coverage, alpha_test, quad_interlock"},
    PresetSetting{"depth.test", "late", Rtl, "behind the alpha test"},
    PresetSetting{"depth_cache.enable", "false", Rtl, NoCache},
    PresetSetting{
        "depth_cache.fragment_fifo", Text<pipe_number("TargetQuads")>, Rtl, "quad_interlock"},
    PresetSetting{"depth_cache.store_cycles",
                  Text<DepthStore>,
                  Rtl,
                  "stencil_depth, target_write, and its release"},
    PresetSetting{"depth_cache.latency", Text<ToColor>, Rtl, "stencil_depth, quad_interlock"},
    PresetSetting{"depth_cache.line_bytes", "16", Rtl, Pixels},
    PresetSetting{"depth_cache.block_width", "2", Rtl, Pixels},
    PresetSetting{"color_cache.enable", "false", Rtl, NoCache},
    PresetSetting{
        "color_cache.fragment_fifo", Text<pipe_number("TargetQuads")>, Rtl, "quad_interlock"},
    PresetSetting{
        "color_cache.store_cycles", Text<ColorStore>, Rtl, "blend, target_write, and its release"},
    PresetSetting{"color_cache.line_bytes", "16", Rtl, Pixels},
    PresetSetting{"color_cache.block_width", "2", Rtl, Pixels},
    PresetSetting{"memory.kind", "fixed", Rtl, "what a bench has at the pipe's ports"},
    PresetSetting{"memory.channels", "16", Rtl, "no port waits for another"},
    PresetSetting{"memory.latency", "20", Rtl, "what ffgpu replay --rtl has by default"},
    PresetSetting{"bottlenecks.enable", "false", Rtl, "not reckoned for this pipe"}};

} // namespace rtl_pipe
} // namespace ffgpu::timing
