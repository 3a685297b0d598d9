// What the machine accounts for: its stages, among which bottlenecks are looked for, and its
// figures.

#include "model/timing/machine.h"

namespace ffgpu::timing {

namespace {

// Quads are looked up, wait for their data, and leave.
void add_parked(Stage& stage,
                const ParkedQuads& quads,
                const Link& answers,
                std::uint32_t width,
                std::uint32_t lookups_per_cycle) {
    stage.passages = {{.passage = &quads.passage(),
                       .places = static_cast<std::uint32_t>(quads.capacity()),
                       .answers = &answers}};
    stage.steps = {{.from = {0}, .gives = true, .width = width},
                   {.to = {0},
                    .takes = true,
                    .width = width,
                    .lookups_per_cycle = lookups_per_cycle,
                    .asks = true}};
}

// Without a cache a quad's place is free when its store has been taken.
void hold_until_stored(Stage& stage, const CacheConfig& cache) {
    if (cache.enable) return;
    StagePassage& parked = stage.passages.front();
    parked.back = std::max(cache.store_cycles, 1u);
    parked.back_work = parked.back - 1;
    stage.steps.front().stores = true;
}

// Of all pipes; where quads leave in the order in which they came, they wait for that behind them.
void add_exit(Stage& stage,
              const PipeExit& exit,
              std::uint32_t places,
              const std::vector<std::size_t>& last_steps) {
    if (exit.passages().empty()) return;
    Step out{.gives = true, .width = static_cast<std::uint32_t>(last_steps.size())};
    for (std::size_t pipe = 0; pipe < last_steps.size(); ++pipe) {
        out.from.push_back(stage.passages.size());
        Step& last = stage.steps[last_steps[pipe]];
        last.to.push_back(stage.passages.size());
        last.gives = false;
        stage.passages.push_back(
            {.passage = &exit.passages()[pipe], .places = places, .through = 0, .back = 1});
    }
    stage.steps.push_back(std::move(out));
}

} // namespace

void Machine::add_vertex_steps(Stage& fetch, Stage& transform, Stage& set_up) {
    const VertexConfig& vertex = config.vertex;
    const std::uint32_t width = vertex.vertices_per_cycle, units = config.setup.units;
    const std::uint32_t most = fetch.free_width;
    const CachePort& indices = vertex.index_cache_lines > 0 ? index_port : vertex_port;
    fetch.passages = {{.passage = &vertex_fetch.to_vertices(),
                       .places = vertex.index_queue,
                       .answers = &indices.responses},
                      {.passage = &vertex_fetch.to_geometry(),
                       .places = vertex.fetch_queue,
                       .answers = &vertex_port.responses,
                       .works_first = true}};
    fetch.steps = {
        {.from = {1}, .gives = true, .width = width, .free_width = most, .free_cycles = 0},
        {.from = {0},
         .to = {1},
         .width = width,
         .free_width = most,
         .lookups_per_cycle = width,
         .asks = true},
        {.to = {0}, .takes = true, .width = width, .free_width = most, .asks = true}};
    transform.passages = {{.passage = &geometry.passage(),
                           .places = std::max(vertex.order_entries, vertex.units),
                           .through = 0,
                           .back = 1,
                           .units = vertex.units}};
    transform.steps = {{.to = {0}, .takes = true, .width = width},
                       {.from = {0}, .gives = true, .width = std::max(width, units)}};
    set_up.passages = {{.passage = &setup.passage(), .places = units, .through = 0, .back = 1}};
    set_up.steps = {{.to = {0}, .takes = true, .width = units, .takes_when_done = true},
                    {.from = {0}, .gives = true, .width = units}};
}

void Machine::add_texture_steps(Stage& stage) {
    const std::uint32_t pipes = config.raster.quads_per_cycle;
    stage.steps = {{.takes = true, .width = pipes}};
    const std::vector<CachePort*> caches = texel_caches.first_level();
    std::vector<std::size_t> filters;
    for (const TexturePipe& pipe : texture.pipes()) {
        const std::size_t tags = stage.passages.size(), filter = tags + 1;
        stage.passages.push_back({.passage = &pipe.to_tags(),
                                  .places = config.fragment.pipe_queue,
                                  .through = 0,
                                  .back = 1,
                                  .works_first = true});
        stage.passages.push_back({.passage = &pipe.to_filter(),
                                  .places = config.texel_cache.fragment_fifo,
                                  .answers = &caches[filters.size() % caches.size()]->responses,
                                  .works_first = true});
        stage.steps[0].to.push_back(tags);
        filters.push_back(stage.steps.size());
        stage.steps.push_back({.from = {filter}, .gives = true});
        stage.steps.push_back({.from = {tags}, .to = {filter}, .asks = true});
    }
    add_exit(stage, texture.exit(), config.fragment.pipe_queue, filters);
}

// Texels go from the tags to the data, quads on from there; and those in all of the unit have
// pipe_queue places. Without the resource there are quads alone, and only the places before the
// tags.
void Machine::add_texel_steps(Stage& stage) {
    const std::uint32_t pipes = config.raster.quads_per_cycle;
    constexpr std::uint32_t Many = 64;
    constexpr std::uint32_t NoLimit = 1 << 20;
    stage.steps = {{.takes = true, .width = pipes}};
    const std::vector<CachePort*> caches = texel_caches.first_level();
    std::vector<std::size_t> exits;
    for (const TexturePipe& pipe : texture.pipes()) {
        const std::size_t tags = stage.passages.size(), data = tags + 1, exit = tags + 2,
                          inside = tags + 3;
        const std::uint32_t places = config.fragment.pipe_queue;
        stage.passages.push_back({.passage = &pipe.to_tags(),
                                  .places = places,
                                  .through = 0,
                                  .back = 1,
                                  .works_first = true});
        stage.passages.push_back({.passage = &pipe.to_filter(),
                                  .places = config.texture.texel_queue,
                                  .back_work = NoLimit,
                                  .answers = &caches[exits.size() % caches.size()]->responses,
                                  .works_first = true});
        stage.passages.push_back({.passage = &pipe.to_exit(),
                                  .places = places,
                                  .through = config.texture.latency,
                                  .back = 1,
                                  .through_work = config.texture.latency});
        stage.passages.push_back({.passage = &pipe.inside(),
                                  .places = places,
                                  .through = 0,
                                  .back = 1,
                                  .back_work = NoLimit});
        stage.steps[0].to.insert(stage.steps[0].to.end(), {tags, inside});
        stage.steps.push_back({.from = {data}, .to = {exit}, .free_width = Many, .free_cycles = 0});
        exits.push_back(stage.steps.size());
        stage.steps.push_back({.from = {exit, inside}, .gives = true});
        stage.steps.push_back({.from = {tags}, .to = {data}, .asks = true});
    }
    add_exit(stage, texture.exit(), config.fragment.pipe_queue, exits);
}

void Machine::add_fragment_steps(Stage& stage) {
    const std::uint32_t pipes = config.raster.quads_per_cycle;
    const FragmentConfig& fragments = config.fragment;
    stage.steps = {{.takes = true, .width = pipes}};
    std::vector<std::size_t> last;
    for (std::size_t pipe = 0; pipe < pipes; ++pipe) {
        stage.passages.push_back({.passage = &fragment.to_pipe(pipe),
                                  .places = fragments.pipe_queue,
                                  .through = 0,
                                  .back = 1,
                                  .works_first = fragments.entry_cycles > 0});
        stage.steps[0].to.push_back(pipe);
        last.push_back(stage.steps.size());
        stage.steps.push_back({.from = {pipe}, .gives = true});
    }
    add_exit(stage, fragment.exit(), fragments.pipe_queue, last);
}

// A walk that takes each block a cycle or more is a step of its own; what it walks to is made into
// quads behind it. Without the resource's limits there are the quads alone.
Stage Machine::raster_stage() {
    const std::uint32_t pipes = config.raster.quads_per_cycle;
    Stage stage{.resource = Resource::Raster, .unit = &raster, .width = pipes, .free_width = pipes};
    if (config.raster.walk != Walk::Box || config.raster.tile_cycles == 0) return stage;
    stage.passages = {{.passage = &raster.blocks(),
                       .places = config.raster.block_queue,
                       .back = 1,
                       .through_work = 1,
                       .back_work = 1,
                       .units = 1}};
    stage.steps = {
        {.to = {0}, .takes = true},
        {.from = {0}, .gives = true, .width = pipes, .free_width = pipes, .free_cycles = 0}};
    return stage;
}

// Without its limits there is none.
Stage Machine::interpolator_stage() {
    const std::uint32_t pipes = config.raster.quads_per_cycle;
    return {.resource = Resource::Interpolator,
            .unit = interpolator.get(),
            .free_width = pipes,
            .passages = {{.passage = &interpolator->passage(),
                          .places = config.interpolator.divide_queue,
                          .works_first = true}},
            .steps = {{.from = {0}, .gives = true, .free_width = pipes, .free_cycles = 0},
                      {.to = {0}, .takes = true, .free_width = pipes}}};
}

// Requests are looked up, wait for their lines, each first-level cache's in a queue of its own, and
// are answered.
Stage Machine::second_level_stage() {
    constexpr std::uint32_t Most = 64;
    constexpr std::size_t MostQueues = 8; // Of more there would be more than are followed.
    TexelL2& unit = *texel_caches.unit();
    const TexelL2Config& l2 = config.texel_l2;
    Stage stage{.resource = Resource::TexelL2,
                .unit = &unit,
                .width = l2.lookups_per_cycle,
                .free_width = Most};
    const std::size_t clients = texel_caches.first_level().size();
    if (clients > MostQueues) return stage;
    Step look_up{.takes = true,
                 .width = l2.lookups_per_cycle,
                 .free_width = Most,
                 .lookups_per_cycle = l2.lookups_per_cycle,
                 .asks = true};
    const std::uint32_t answers = std::max(l2.bytes_per_cycle / config.texel_cache.line_bytes, 1u);
    for (std::size_t queue = 0; queue < clients; ++queue) {
        stage.passages.push_back({.passage = &unit.waiting(queue),
                                  .places = l2.queue,
                                  .answers = &texel_caches.second_level_port().responses,
                                  .works_first = true});
        stage.steps.push_back({.from = {queue},
                               .gives = true,
                               .width = answers,
                               .free_width = Most,
                               .free_cycles = 0});
        look_up.to.push_back(queue);
    }
    stage.steps.push_back(std::move(look_up));
    return stage;
}

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
    const std::uint32_t depth_lookups = config.depth_cache.lookups_per_cycle * pipes;
    add_parked(early, depth.early(), depth_port.responses, pipes, depth_lookups);
    Stage late = stage(Resource::Depth, depth, pipes, pipes);
    late.input = &fragment_to_depth;
    late.output = &depth_to_color;
    late.is_answered = false;
    add_parked(late, depth.late(), depth_port.responses, pipes, depth_lookups);
    hold_until_stored(late, config.depth_cache);
    Stage blend = stage(Resource::Color, color, pipes, pipes);
    add_parked(blend,
               color.quads(),
               color_port.responses,
               pipes,
               config.color_cache.lookups_per_cycle * pipes);
    hold_until_stored(blend, config.color_cache);
    Stage textured = stage(Resource::Texture, texture, pipes, pipes);
    textured.expands = config.texel_cache.decompress_cycles > 0;
    // Of many pipes there would be more passages than are followed.
    constexpr std::uint32_t MostTexelPipes = 8;
    if (config.texture.rate == TexelRate::Samples)
        add_texture_steps(textured);
    else if (pipes <= MostTexelPipes)
        add_texel_steps(textured);
    Stage combined = stage(Resource::Fragment, fragment, pipes, pipes);
    add_fragment_steps(combined);
    Stage fetch = stage(Resource::VertexFetch, vertex_fetch, vertex.vertices_per_cycle, Most);
    Stage transform =
        stage(Resource::Geometry, geometry, vertex.vertices_per_cycle, vertex.vertices_per_cycle);
    Stage set_up = stage(Resource::Setup, setup, set_ups, Most);
    add_vertex_steps(fetch, transform, set_up);
    std::vector<Stage> stages{stage(Resource::Host, host, 1, Any),
                              stage(Resource::CommandProcessor, command_processor, 1, 1),
                              fetch,
                              transform,
                              stage(Resource::Clip, clip, set_ups, set_ups),
                              set_up,
                              raster_stage(),
                              early,
                              textured,
                              combined,
                              late,
                              blend};
    if (tiles) {
        const std::vector<Stage> more = tiles->stages();
        stages.insert(stages.begin() + 6, more.begin(), more.end()); // behind set-up
    }
    if (interpolator) stages.insert(stages.begin() + 7, interpolator_stage()); // behind raster
    if (texel_caches.unit()) stages.insert(stages.begin(), second_level_stage());
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

std::vector<LineCache*> Machine::caches() {
    std::vector<LineCache*> all{
        &index_port.cache, &vertex_port.cache, &depth_port.cache, &color_port.cache};
    for (CachePort* const port : texel_caches.first_level())
        all.push_back(&port->cache);
    if (LineCache* const second = texel_caches.second_level()) all.push_back(second);
    return all;
}

void Machine::leave_out_figures() {
    for (LineCache* const cache : caches())
        cache->leave_out_kinds();
    for (const Link* const link : links())
        link->leave_out_counts();
    arbiter.leave_out_figures();
    memory->leave_out_figures();
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
