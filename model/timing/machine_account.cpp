// What the machine accounts for: its stages, among which bottlenecks are looked for, and its
// figures.

#include "model/timing/machine.h"

namespace ffgpu::timing {

// The way of the work: what each waits for is behind it, or the memory. What is before the pipe
// waits for nobody behind it.
std::vector<Stage> Machine::stages() {
    const VertexConfig& vertex = config.vertex;
    const std::uint32_t set_ups = config.setup.units, pipes = config.raster.quads_per_cycle;
    const auto stage = [](Resource resource, Unit& unit, std::uint32_t width, std::uint32_t free) {
        return Stage{.resource = resource, .unit = &unit, .width = width, .free_width = free};
    };
    constexpr std::uint32_t Any = 0, Most = 16;
    Stage early = stage(Resource::Depth, depth, pipes, pipes);
    early.input = &raster_to_depth;
    early.output = &depth_to_texture;
    early.lookups = {&depth_port.cache.statistics().accesses};
    early.lookups_per_cycle = config.depth_cache.lookups_per_cycle * pipes;
    Stage late = early;
    late.input = &fragment_to_depth;
    late.output = &depth_to_color;
    Stage blend = stage(Resource::Color, color, pipes, pipes);
    blend.lookups = {&color_port.cache.statistics().accesses};
    blend.lookups_per_cycle = config.color_cache.lookups_per_cycle * pipes;
    Stage textured = stage(Resource::Texture, texture, pipes, pipes);
    textured.expands = config.texel_cache.decompress_cycles > 0;
    std::vector<Stage> stages{
        stage(Resource::Host, host, 1, Any),
        stage(Resource::CommandProcessor, command_processor, 1, 1),
        stage(Resource::VertexFetch, vertex_fetch, vertex.vertices_per_cycle, Most),
        stage(Resource::Geometry, geometry, vertex.vertices_per_cycle, vertex.vertices_per_cycle),
        stage(Resource::Clip, clip, set_ups, set_ups),
        stage(Resource::Setup, setup, set_ups, Most),
        stage(Resource::Raster, raster, pipes, pipes),
        early,
        textured,
        stage(Resource::Fragment, fragment, pipes, pipes),
        late,
        blend};
    if (tiles) {
        const std::vector<Stage> more = tiles->stages();
        stages.insert(stages.begin() + 6, more.begin(), more.end()); // behind set-up
    }
    if (Unit* const unit = texel_caches.unit())
        stages.insert(stages.begin(),
                      stage(Resource::TexelL2, *unit, config.texel_l2.lookups_per_cycle, 4 * Most));
    return stages;
}

void Machine::look_for_bottlenecks(Pace pace) {
    if (!config.bottlenecks.enable) return;
    const MemoryArbiter::Ports ports = memory_ports();
    bottlenecks = std::make_unique<BottleneckSearch>(
        clock,
        PipeParts{.stages = stages(),
                  .requests = {ports.requests_in.begin(), ports.requests_in.end()},
                  .responses = {ports.responses_out.begin(), ports.responses_out.end()},
                  .arbiter = arbiter,
                  .drain = command_processor,
                  .memory = config.memory,
                  .memory_is_ours =
                      memory->unit() != nullptr && config.memory.kind == MemoryKind::Dram},
        pace != Pace::EveryCycle);
    arbiter.set_waits(&bottlenecks->watch());
    clock.set_on_walked([this] { bottlenecks->end_cycle(ledger.charged(clock.now())); });
}

std::vector<const StatisticsGroup*> Machine::statistics() {
    std::vector<const StatisticsGroup*> groups{&frame_statistics};
    for (Unit* unit : units())
        groups.push_back(&unit->account());
    groups.push_back(&bottleneck_statistics);
    groups.push_back(&host.statistics());
    groups.push_back(&vertex_fetch.statistics());
    groups.push_back(&clip.statistics());
    groups.push_back(&raster.statistics());
    groups.push_back(&scan_out.statistics());
    if (tiles)
        for (const StatisticsGroup* const group : tiles->statistics())
            groups.push_back(group);
    groups.push_back(&texture.statistics());
    for (const CachePort* port : {&index_port, &vertex_port})
        groups.push_back(&port->cache.statistics());
    for (const StatisticsGroup* group : texel_caches.statistics())
        groups.push_back(group);
    for (const CachePort* port : {&depth_port, &color_port})
        groups.push_back(&port->cache.statistics());
    for (const StatisticsGroup* group : blocks.statistics())
        groups.push_back(group);
    groups.push_back(&arbiter.statistics());
    for (const StatisticsGroup* group : memory->statistics())
        groups.push_back(group);
    groups.push_back(queues.get());
    return groups;
}

std::vector<const Histogram*> Machine::histograms() {
    std::vector<const Histogram*> all = shapes.histograms();
    for (const auto& histograms : {arbiter.statistics().histograms(), queues->histograms()})
        all.insert(all.end(), histograms.begin(), histograms.end());
    return all;
}

std::vector<const Link*> Machine::links() {
    std::vector<const Link*> links;
    for (const Unit* unit : units())
        links.insert(links.end(), unit->inputs().begin(), unit->inputs().end());
    return links;
}

} // namespace ffgpu::timing
