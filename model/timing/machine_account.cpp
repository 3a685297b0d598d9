// What the machine accounts for: its stages, among which bottlenecks are looked for, and its
// figures.

#include "model/timing/machine.h"

namespace ffgpu::timing {

// The way of the work: what each waits for is behind it, or the memory.
std::vector<Stage> Machine::stages() {
    std::vector<Stage> stages{
        {Resource::Host, &host, {Client::Host}},
        {Resource::CommandProcessor,
         &command_processor,
         {Client::Command, Client::Color, Client::Depth}},
        {Resource::VertexFetch, &vertex_fetch, {Client::Vertex, Client::Index}},
        {Resource::Geometry, &geometry, {}},
        {Resource::Clip, &clip, {}},
        {Resource::Setup, &setup, {}},
        {Resource::Raster, &raster, {}},
        {Resource::Depth, &depth, {Client::Depth}, &raster_to_depth, &depth_to_texture},
        {Resource::Texture, &texture, {Client::Texture}},
        {Resource::Fragment, &fragment, {}},
        {Resource::Depth, &depth, {Client::Depth}, &fragment_to_depth, &depth_to_color},
        {Resource::Color, &color, {Client::Color}}};
    if (tiles) {
        const std::vector<Stage> more = tiles->stages();
        stages.insert(stages.begin() + 6, more.begin(), more.end()); // behind set-up
    }
    return stages;
}

std::vector<const StatisticsGroup*> Machine::statistics() {
    std::vector<const StatisticsGroup*> groups{&frame_statistics};
    for (Unit* unit : units())
        groups.push_back(&unit->account());
    groups.push_back(&bottlenecks->statistics());
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
