#include "model/timing/presets.h"

#include "model/timing/rtl_pipe_preset.h"

#include <algorithm>
#include <array>

namespace ffgpu::timing {
namespace {

constexpr std::string_view Assumed = "assumed";

constexpr std::array Sources{
    PresetSource{"gpu-tech",
                 "gpu-tech.org, From Voodoo Graphics to VSA-100 and beyond (forum article)"},
    PresetSource{"gamegpu-tnt", "gamegpu.tech, RIVA TNT, table of characteristics"},
    PresetSource{"amdarea51", "amdarea51.de, nVIDIA GeForce 1 Serie, table"},
    PresetSource{"anandtech-forum",
                 "forums.anandtech.com, Difference between GeForce cards (thread 386828)"},
    PresetSource{"tweak3d", "tweak3d.net, GeForce 2 GTS Features / Specifications, April 26, 2000"},
    PresetSource{"neoseeker", "neoseeker.com, VisionTek GeForce 2 Ultra review, December 21, 2000"},
    PresetSource{"technical-news", "technical-news.net, Kyro II Ultra and Kyro III this year"},
    PresetSource{"wikipedia-2700g", "en.wikipedia.org, Intel 2700G"},
    PresetSource{"tomshw-mbx", "tomshw.it, PowerVR MBX (2001), table"},
    PresetSource{"rtl", "rtl/fragment_pipe.sv and the files of its units; docs/rtl_cycles.md"}};

// What a chip without geometry units gets from the host's processor.
constexpr PresetSetting HostTransforms{
    "vertex.transform_cycles", "1", Assumed, "the host transforms; the chip does not wait for it"};
constexpr PresetSetting HostLights{"vertex.light_cycles", "0", Assumed, "the host lights"};

// A bus of 128 bits, of four chips.
constexpr PresetSetting WideRows{
    "memory.row_bytes", "4096", Assumed, "four chips of 32 bits, each with pages of 1 KB"};
constexpr PresetSetting BanksApart{
    "memory.bank_hash",
    "xor",
    Assumed,
    "depth and colour in other banks, as on the maker's chips from 2003 on (nouveau, nv30_fb)"};

constexpr std::array Voodoo{
    PresetSetting{"clock.core_mhz", "50", "gpu-tech", "50 MHz standard clock rate"},
    PresetSetting{"memory.profile", "sdr", Assumed, "EDO DRAM has no profile of its own"},
    PresetSetting{"memory.channels",
                  "2",
                  "gpu-tech",
                  "two interfaces, one for textures; shared "
                  "here"},
    PresetSetting{"memory.bytes_per_cycle", "8", "gpu-tech", "each 64 bits wide"},
    PresetSetting{"memory.core_clocks", "1", Assumed, "memory at the chip's clock"},
    PresetSetting{"memory.memory_clocks", "1", Assumed, "memory at the chip's clock"},
    PresetSetting{"fragment.quad_cycles", "4", "gpu-tech", "one pixel a clock"},
    PresetSetting{"fragment.combiner_cycles", "4", "gpu-tech", "one texture a pixel and clock"},
    PresetSetting{"setup.triangle_cycles", "50", Assumed, "1 million triangles a second"},
    HostTransforms,
    HostLights,
    PresetSetting{"texel_cache.sets", "1", Assumed, "next to no texel cache"},
    PresetSetting{"texel_cache.ways", "4", Assumed, "next to no texel cache"}};

constexpr std::array RivaTnt{
    PresetSetting{"clock.core_mhz", "90", "gamegpu-tnt", "core frequency"},
    PresetSetting{"memory.profile", "sdr", "gamegpu-tnt", "SDR"},
    PresetSetting{"memory.channels", "1", "gamegpu-tnt", "one bus"},
    WideRows,
    BanksApart,
    PresetSetting{"memory.bytes_per_cycle", "16", "gamegpu-tnt", "128 bits"},
    PresetSetting{"memory.core_clocks", "90", "gamegpu-tnt", "core frequency"},
    PresetSetting{"memory.memory_clocks", "110", "gamegpu-tnt", "memory frequency"},
    PresetSetting{"fragment.quad_cycles", "2", "gamegpu-tnt", "two pixel pipelines"},
    PresetSetting{"fragment.combiner_cycles", "2", "gamegpu-tnt", "two textures a clock"},
    PresetSetting{"setup.triangle_cycles", "15", Assumed, "6 million triangles a second"},
    HostTransforms,
    HostLights};

// Both boards with the GeForce 256.
constexpr PresetSetting Nv10Clock{"clock.core_mhz", "120", "amdarea51", "GPU clock"};
constexpr PresetSetting Nv10CoreClocks{"memory.core_clocks", "120", "amdarea51", "GPU clock"};
constexpr PresetSetting OneBus{"memory.channels", "1", Assumed, "one bus of the whole width"};
constexpr PresetSetting Nv10Vertices{"vertex.transform_cycles",
                                     "12",
                                     "anandtech-forum",
                                     "10 million polygons a second, a vertex each"};
constexpr PresetSetting Nv10Triangles{
    "setup.triangle_cycles", "12", "anandtech-forum", "10 million polygons a second"};

constexpr std::array GeForce256Sdr{
    Nv10Clock,
    PresetSetting{"memory.profile", "sdr", "amdarea51", "SD"},
    OneBus,
    PresetSetting{"memory.bytes_per_cycle", "16", "amdarea51", "128 bits"},
    Nv10CoreClocks,
    PresetSetting{"memory.memory_clocks", "166", "amdarea51", "memory clock"},
    Nv10Vertices,
    Nv10Triangles};

constexpr std::array GeForce256Ddr{
    Nv10Clock,
    PresetSetting{"memory.profile", "ddr", "amdarea51", "DDR"},
    OneBus,
    PresetSetting{"memory.bytes_per_cycle", "32", "amdarea51", "128 bits, both edges"},
    Nv10CoreClocks,
    PresetSetting{"memory.memory_clocks", "150", "amdarea51", "300 MHz effective"},
    Nv10Vertices,
    Nv10Triangles};

// Four pipes of two texture units.
constexpr PresetSetting TwoTextures{
    "fragment.combiners", "2", "tweak3d", "eight texels and four pixels a clock"};
constexpr PresetSetting TwoUnits{"texture.units", "2", "tweak3d", "eight texels a clock"};
constexpr PresetSetting WideDdr{
    "memory.bytes_per_cycle", "32", "neoseeker", "7.36 GB/s at 230 MHz: 128 bits, both edges"};

constexpr std::array GeForce2Gts{
    PresetSetting{"clock.core_mhz", "200", "tweak3d", "chip clock"},
    PresetSetting{"memory.profile", "ddr", "tweak3d", "DDR"},
    OneBus,
    WideRows,
    BanksApart,
    WideDdr,
    PresetSetting{"memory.core_clocks", "200", "tweak3d", "chip clock"},
    PresetSetting{"memory.memory_clocks", "166", "tweak3d", "166 MHz"},
    TwoTextures,
    TwoUnits,
    PresetSetting{"vertex.transform_cycles",
                  "8",
                  "anandtech-forum",
                  "25 million polygons a second, a vertex each"},
    PresetSetting{"setup.triangle_cycles", "8", "anandtech-forum", "25 million polygons a second"}};

constexpr std::array GeForce2Ultra{
    PresetSetting{"clock.core_mhz", "250", "neoseeker", "core"},
    PresetSetting{"memory.profile", "ddr", "neoseeker", "architecture of the GTS"},
    OneBus,
    WideRows,
    BanksApart,
    WideDdr,
    PresetSetting{"memory.core_clocks", "250", "neoseeker", "core"},
    PresetSetting{"memory.memory_clocks", "230", "neoseeker", "memory"},
    TwoTextures,
    TwoUnits,
    PresetSetting{"vertex.transform_cycles", "8", Assumed, "as the GTS, a clock"},
    PresetSetting{"setup.triangle_cycles", "8", Assumed, "as the GTS, a clock"}};

constexpr PresetSetting TileBased{"raster.architecture", "tile_based", "technical-news", "PowerVR"};
constexpr PresetSetting BinSize{
    "raster.bin_size", "32", Assumed, "bins of 32 x 16 have no setting: they are squares"};

constexpr std::array Kyro{
    PresetSetting{"clock.core_mhz", "115", "technical-news", "clock frequency"},
    TileBased,
    BinSize,
    PresetSetting{"memory.profile", "sdr", Assumed, "1.8 GB/s = 115 MHz x 128 bits"},
    OneBus,
    WideRows,
    PresetSetting{
        "memory.bytes_per_cycle", "16", "technical-news", "1.8 GB/s = 115 MHz x 128 bits"},
    PresetSetting{"memory.core_clocks", "1", Assumed, "memory at the chip's clock"},
    PresetSetting{"memory.memory_clocks", "1", Assumed, "memory at the chip's clock"},
    PresetSetting{"fragment.quad_cycles", "2", "technical-news", "two pixel pipelines"},
    PresetSetting{"fragment.combiner_cycles", "2", "technical-news", "230 million pixels a second"},
    HostTransforms,
    HostLights};

constexpr std::array Mbx{
    PresetSetting{"clock.core_mhz", "75", "wikipedia-2700g", "75 MHz core"},
    PresetSetting{"raster.architecture", "tile_based", "wikipedia-2700g", "PowerVR MBX Lite"},
    BinSize,
    PresetSetting{"memory.profile", "sdr", Assumed, "100 MHz, 32 bits, 400 MB/s: one edge"},
    OneBus,
    PresetSetting{"memory.row_bytes", "1024", Assumed, "one chip of 32 bits, with pages of 1 KB"},
    PresetSetting{"memory.bytes_per_cycle", "4", "wikipedia-2700g", "2700G7: 32-bit bus"},
    PresetSetting{"memory.core_clocks", "75", "wikipedia-2700g", "75 MHz core"},
    PresetSetting{"memory.memory_clocks", "100", "wikipedia-2700g", "2700G7: 100 MHz"},
    PresetSetting{"fragment.quad_cycles", "4", "tomshw-mbx", "one pixel unit"},
    PresetSetting{"fragment.combiner_cycles", "4", "tomshw-mbx", "one texture unit"},
    PresetSetting{
        "setup.triangle_cycles", "90", "wikipedia-2700g", "831,000 triangles a second at 75 MHz"},
    HostTransforms,
    HostLights};

constexpr std::array Presets{
    Preset{"voodoo_graphics",
           "3Dfx Voodoo Graphics, 1996: one pipe, memories for colour and for textures",
           Voodoo},
    Preset{"riva_tnt", "NVIDIA RIVA TNT, 1998: two pipes", RivaTnt},
    Preset{"geforce_256_sdr",
           "NVIDIA GeForce 256 with SDR memory, 1999: four pipes, hardware lighting",
           GeForce256Sdr},
    Preset{"geforce_256_ddr",
           "NVIDIA GeForce 256 with DDR memory, 1999: four pipes, hardware lighting",
           GeForce256Ddr},
    Preset{"geforce2_gts",
           "NVIDIA GeForce2 GTS, 2000: four pipes of two texture units, hardware lighting",
           GeForce2Gts},
    Preset{"geforce2_ultra", "NVIDIA GeForce2 Ultra, 2000: the same, faster", GeForce2Ultra},
    Preset{"kyro", "STMicroelectronics KYRO, 2000: tile-based, two pipes", Kyro},
    Preset{"powervr_mbx", "PowerVR MBX Lite in Intel's 2700G, 2004: tile-based, mobile", Mbx},
    Preset{"rtl_pipe",
           "the fragment pipe of this project in RTL, on a memory without limits",
           rtl_pipe::Settings}};

} // namespace

std::span<const Preset> presets() {
    return Presets;
}

std::span<const PresetSource> preset_sources() {
    return Sources;
}

const Preset* find_preset(std::string_view name) {
    const auto found = std::ranges::find(Presets, name, &Preset::name);
    return found == Presets.end() ? nullptr : &*found;
}

} // namespace ffgpu::timing
