#include "model/timing/without_limit.h"

#include "model/timing/memory_controller.h"
#include "model/timing/memory_kinds.h"

#include <algorithm>

namespace ffgpu::timing {
namespace {

constexpr std::uint32_t Many = 64;      // of what a parameter counts a cycle
constexpr std::uint32_t MostUnits = 16; // of a kind

void without_geometry(VertexConfig& vertex) {
    vertex.units = MostUnits;
    vertex.order_entries = 4096;
    vertex.transform_cycles = 1;
    vertex.light_cycles = 0;
}

void without_setup(SetupConfig& setup) {
    setup.units = MostUnits;
    setup.triangle_cycles = setup.reject_cycles = 1;
    setup.attribute_cycles = setup.plane_cycles = 0;
}

void without_raster(RasterConfig& raster) {
    raster.walk = Walk::Box;
    raster.tile_cycles = raster.empty_tile_cycles = 0;
}

void without_command_processor(TimingConfig& config) {
    config.command_processor.draw_cycles = 1;
    config.command_processor.lines_per_cycle = Many;
    config.depth_blocks.clears_per_cycle = config.color_blocks.clears_per_cycle = 65536;
}

void without_vertex_fetch(VertexConfig& vertex) {
    vertex.vertices_per_cycle = MostUnits;
    vertex.fetch_bytes_per_cycle = 0;
    vertex.ports = 0;
}

// Of a target: depth's or colour's.
template <class Cache>
void without_target(Cache& cache) {
    cache.lookups_per_cycle = Many;
    cache.ports = 0;
    cache.store_cycles = 0;
}

void without_texture(TimingConfig& config) {
    if (config.texture.rate == TexelRate::Texels) // Quads wait for lines in the texels' queue.
        config.texel_cache.fragment_fifo =
            std::max(config.texel_cache.fragment_fifo, config.texture.texel_queue);
    config.texture.rate = TexelRate::Samples;
    config.texel_cache.lookups_per_cycle = Many;
    config.texel_cache.bilinear_quads_per_cycle = MostUnits;
    config.texel_cache.ports = 0;
    config.texel_cache.decompress_cycles = 0;
    config.texture.miss_cycles = 0;
}

void without_second_level(TexelL2Config& cache) {
    cache.lookups_per_cycle = Many;
    cache.latency = 1;
    cache.bytes_per_cycle = 512;
    cache.ports = 0;
}

void without_fragment(FragmentConfig& fragment) {
    fragment.quad_cycles = 1;
    fragment.entry_cycles = 0;
    fragment.combiner_cycles = 1;
    fragment.combiners = 8;
}

// The latency is another resource's.
void without_bandwidth(MemoryConfig& memory) {
    const std::uint32_t latency = memory.latency;
    memory.profile = MemoryProfile::Ideal;
    memory.apply_profile();
    memory.latency = latency;
    memory.channels = 16;
    memory.bytes_per_cycle = 256;
    memory.memory_clocks = memory.core_clocks = 1;
}

void without_links(TimingConfig& config) {
    config.vertex.latency = config.raster.latency = config.interpolator.latency = 1;
    config.fragment.latency = config.depth_cache.latency = 1;
}

} // namespace

bool has_limit(const TimingConfig& config, Resource resource) {
    switch (resource) {
    case Resource::Binner:
    case Resource::ParameterFetch:
    case Resource::TileMemory:
        return config.raster.architecture == Architecture::TileBased;
    case Resource::TexelL2:
        return config.texel_l2.enable;
    case Resource::Interpolator:
        return config.interpolator.is_on();
    case Resource::MemoryBandwidth:
        return config.memory.kind != MemoryKind::Fixed;
    case Resource::Count:
        return false;
    default:
        return true;
    }
}

TimingConfig without_limit(TimingConfig config, Resource resource) {
    // A delay line keeps its places, whatever its width and latency are now.
    config.clip.kept_places = config.primitive_places();
    switch (resource) {
    case Resource::Host:
        config.host.bytes_per_cycle = 0;
        break;
    case Resource::CommandProcessor:
        without_command_processor(config);
        break;
    case Resource::VertexFetch:
        without_vertex_fetch(config.vertex);
        break;
    case Resource::Geometry:
        without_geometry(config.vertex);
        break;
    case Resource::Clip:
        config.clip.plane_cycles = 0;
        break;
    case Resource::Setup:
        without_setup(config.setup);
        break;
    case Resource::Binner:
        config.tiles.entries_per_cycle = Many;
        break;
    case Resource::ParameterFetch:
        config.tiles.entry_cycles = 1;
        break;
    case Resource::TileMemory:
        config.tiles.clear_pixels_per_cycle = 4096;
        config.tiles.lines_per_cycle = Many;
        break;
    case Resource::Raster:
        without_raster(config.raster);
        break;
    case Resource::Depth:
        without_target(config.depth_cache);
        break;
    case Resource::Texture:
        without_texture(config);
        break;
    case Resource::TexelL2:
        without_second_level(config.texel_l2);
        break;
    case Resource::Fragment:
        without_fragment(config.fragment);
        break;
    case Resource::Color:
        without_target(config.color_cache);
        break;
    case Resource::MemoryBandwidth:
        without_bandwidth(config.memory);
        break;
    case Resource::MemoryLatency:
        config.memory.latency = 0;
        break;
    case Resource::Links:
        without_links(config);
        break;
    case Resource::Interpolator:
        config.interpolator.value_cycles = 0;
        break;
    case Resource::Count:
        break;
    }
    return config;
}

// A memory has a place for every other cycle of its latency, and one.
MakeMemory memory_as_deep_as(const TimingConfig& config) {
    if (config.memory.kind == MemoryKind::Fixed) return configured_memory; // It takes any number.
    const std::uint32_t latency = config.memory.latency;
    return [latency](const Clock& clock, const MemoryConfig& memory) {
        const std::size_t there = 1 + latency / 2, nearer = 1 + memory.latency / 2;
        return std::make_unique<MemoryController>("memory", clock, memory, 2 * there - nearer);
    };
}

} // namespace ffgpu::timing
