#include "model/timing/machine.h"

#include "model/timing/machine_stuck.h"
#include "model/timing/memory_kinds.h"

#include <utility>

namespace ffgpu::timing {
namespace {

CacheConfig vertex_cache(const VertexConfig& config) {
    CacheConfig cache;
    cache.sets = config.cache_sets;
    cache.ways = config.cache_ways;
    cache.line_bytes = config.line_bytes;
    cache.outstanding_lines = config.outstanding_lines;
    static_cast<CacheQueuesConfig&>(cache) = config;
    return cache;
}

// Fully associative; a cache that is not used has a line, too.
CacheConfig index_cache(const VertexConfig& config) {
    CacheConfig cache = vertex_cache(config);
    cache.sets = 1;
    cache.ways = std::max(config.index_cache_lines, 1u);
    return cache;
}

// From the unit that makes quads whole: rasterizer or interpolator.
Cycle latency_of_quads(const TimingConfig& config) {
    return config.interpolator.is_on() ? config.interpolator.latency : config.raster.latency;
}

} // namespace

Machine::Machine(const SimulationContext& kernel,
                 const TimingConfig& wanted,
                 const Evaluation& evaluation,
                 const MakeMemory& make_memory)
    : context(kernel)
    , config(wanted)
    , clock(
          "clock", [this] { return must_wait(); }, evaluation.pace)
    , in_flight(clock)
    , memory_in_flight(clock)
    , screen_in_flight(clock)
    , host_requests(clock, config.memory.client_queue, memory_in_flight)
    , command_requests(clock, config.memory.client_queue, memory_in_flight)
    , screen_requests(clock, config.memory.client_queue, screen_in_flight)
    , host_responses(clock, ResponseQueue)
    , command_responses(clock, ResponseQueue)
    , screen_responses(clock, ResponseQueue)
    , index_port("index_cache", clock, index_cache(config.vertex), Client::Index, memory_in_flight)
    , vertex_port(
          "vertex_cache", clock, vertex_cache(config.vertex), Client::Vertex, memory_in_flight)
    , depth_port("depth_cache", clock, config.depth_cache, Client::Depth, memory_in_flight)
    , color_port("color_cache", clock, config.color_cache, Client::Color, memory_in_flight)
    , texel_caches(clock, config, memory_in_flight)
    , blocks(config)
    , commands(clock, config.host.queue)
    , drained(clock, 1)
    , draws(clock, 4)
    , vertices(clock, config.vertex.fetch_queue)
    , primitives(
          clock, config.primitive_places() - (config.vertex.latency - 1), config.vertex.latency)
    , clipped(clock, config.setup.queue)
    , setups(clock, config.setup.queue)
    , bins(clock, 1)
    , raster_to_interpolator(clock, config.raster.queue, config.raster.latency)
    , raster_to_depth(
          clock, config.raster.queue, latency_of_quads(config), config.raster.quads_per_cycle)
    , depth_to_texture(clock,
                       config.fragment.queue,
                       config.depth_cache.enable ? 1 : latency_of_quads(config),
                       config.raster.quads_per_cycle)
    , texture_to_fragment(clock, config.fragment.queue)
    , fragment_to_depth(
          clock, config.fragment.queue, config.fragment.latency, config.raster.quads_per_cycle)
    , depth_to_color(
          clock, config.fragment.queue, config.depth_cache.latency, config.raster.quads_per_cycle)
    , host("host",
           clock,
           config,
           {.commands_out = commands,
            .drained_in = drained,
            .requests_out = host_requests,
            .responses_in = host_responses,
            .ledger = ledger})
    , command_processor("command_processor",
                        clock,
                        config,
                        {.commands_in = commands,
                         .draws_out = draws,
                         .drained_out = drained,
                         .requests_out = command_requests,
                         .responses_in = command_responses,
                         .depth_cache = depth_port.cache,
                         .color_cache = color_port.cache,
                         .depth_blocks = blocks.depth.get(),
                         .color_blocks = blocks.color.get(),
                         .ledger = ledger},
                        in_flight,
                        memory_in_flight)
    , vertex_fetch("vertex_fetch",
                   clock,
                   config.vertex,
                   {.draws_in = draws,
                    .vertices_out = vertices,
                    .responses_in = vertex_port.responses,
                    .cache = vertex_port.cache,
                    .index_responses_in = index_port.responses,
                    .index_cache = index_port.cache})
    , geometry("geometry", clock, config, {.vertices_in = vertices, .primitives_out = primitives})
    , clip("clip", clock, config, {.primitives_in = primitives, .primitives_out = clipped})
    , setup("setup", clock, config, {.primitives_in = clipped, .setups_out = setups})
    , tiles(config.raster.architecture == Architecture::TileBased
                ? std::make_unique<TilePath>(clock,
                                             config,
                                             TilePath::Ports{.setups_in = setups,
                                                             .bins_out = bins,
                                                             .in_flight = in_flight,
                                                             .memory_in_flight = memory_in_flight})
                : nullptr)
    , raster("raster",
             clock,
             config.raster,
             {.setups_in = setups,
              .bins_in = bins,
              .quads_out = config.interpolator.is_on() ? raster_to_interpolator : whole_quads()},
             in_flight)
    , interpolator(config.interpolator.is_on()
                       ? std::make_unique<InterpolatorTiming>(
                             "interpolator",
                             clock,
                             config.interpolator,
                             InterpolatorTiming::Ports{.quads_in = raster_to_interpolator,
                                                       .quads_out = whole_quads()})
                       : nullptr)
    , depth("depth",
            clock,
            config,
            {.early_in = raster_to_depth,
             .early_out = depth_to_texture,
             .late_in = fragment_to_depth,
             .late_out = depth_to_color,
             .responses_in = depth_port.responses,
             .cache = depth_port.cache,
             .blocks = blocks.depth.get(),
             .coarse = blocks.coarse.get()},
            in_flight,
            [this](const QuadToken& token, Cycle now) { tell_end(token, 0, now); })
    , texture("texture",
              clock,
              config,
              {.quads_in = depth_to_texture,
               .quads_out = texture_to_fragment,
               .caches = texel_caches.first_level(),
               .second_level = texel_caches.second_level(),
               .rewrites = rewrites})
    , fragment("fragment",
               clock,
               config,
               {.quads_in = texture_to_fragment, .quads_out = fragment_to_depth})
    , color("color",
            clock,
            config,
            {.quads_in = depth_to_color,
             .responses_in = color_port.responses,
             .cache = color_port.cache,
             .blocks = blocks.color.get()},
            in_flight,
            [this](const QuadToken& token, Cycle now) { retire(token, now); })
    , scan_out("scan_out",
               clock,
               config.scan_out,
               {.requests_out = screen_requests, .responses_in = screen_responses})
    , arbiter("arbiter", clock, config.memory, memory_ports(), memory_in_flight)
    , memory(make_memory ? make_memory(clock, config.memory)
                         : configured_memory(clock, config.memory)) {
    arbiter.set_ledger(&ledger);
    depth_port.cache.set_store(blocks.depth.get());
    color_port.cache.set_store(blocks.color.get());
    connect_links();
    attach_units(evaluation.order);
    queues = std::make_unique<QueueStatistics>(links());
    if (config.series.interval_cycles > 0) {
        series = std::make_unique<SeriesRecorder>("series", clock, config.series.interval_cycles);
        series->attach();
    }
    look_for_bottlenecks(evaluation.pace);
    // A memory whose processes are its own sees each cycle.
    if (!memory->unit() && evaluation.pace == Pace::Decoupled) clock.set_pace(Pace::Lockstep);
}

// A machine without a depth cache has nothing to test early.
Channel<QuadToken>& Machine::whole_quads() {
    return config.depth_cache.enable ? raster_to_depth : depth_to_texture;
}

void Machine::connect_links() {
    commands.connect("commands", host, command_processor);
    drained.connect("drained", command_processor, host);
    draws.connect("draws", command_processor, vertex_fetch);
    vertices.connect("vertices", vertex_fetch, geometry);
    primitives.connect("primitives", geometry, clip);
    clipped.connect("clipped", clip, setup);
    if (tiles) {
        tiles->connect(setup, raster, arbiter);
    } else {
        setups.connect("setups", setup, raster);
    }
    Unit& quads = interpolator ? static_cast<Unit&>(*interpolator) : raster;
    const std::string from = quads.account().unit();
    if (interpolator)
        raster_to_interpolator.connect("raster_to_interpolator", raster, *interpolator);
    if (config.depth_cache.enable) {
        raster_to_depth.connect(from + "_to_depth", quads, depth);
        depth_to_texture.connect("depth_to_texture", depth, texture);
    } else {
        depth_to_texture.connect(from + "_to_texture", quads, texture);
    }
    texture_to_fragment.connect("texture_to_fragment", texture, fragment);
    fragment_to_depth.connect("fragment_to_depth", fragment, depth);
    depth_to_color.connect("depth_to_color", depth, color);
    connect_memory(host, host_requests, host_responses);
    connect_memory(command_processor, command_requests, command_responses);
    index_port.connect(vertex_fetch, arbiter);
    vertex_port.connect(vertex_fetch, arbiter);
    texel_caches.connect(texture, arbiter);
    depth_port.connect(depth, arbiter);
    color_port.connect(color, arbiter);
    connect_memory(scan_out, screen_requests, screen_responses);
    memory->connect(arbiter);
    arbiter.socket.bind(memory->target());
    if (clock.pace() != Pace::EveryCycle) arbiter.go_directly(*memory);
}

MemoryArbiter::Ports Machine::memory_ports() {
    MemoryArbiter::Ports ports{{&command_requests.channel()}, {&command_responses}};
    const auto add = [&](CachePort& port) {
        ports.requests_in.push_back(&port.requests.channel());
        ports.responses_out.push_back(&port.responses);
    };
    add(vertex_port);
    for (CachePort* port : texel_caches.at_memory())
        add(*port);
    add(depth_port);
    add(color_port);
    add(index_port);
    ports.requests_in.insert(ports.requests_in.end(),
                             {&host_requests.channel(), &screen_requests.channel()});
    ports.responses_out.insert(ports.responses_out.end(), {&host_responses, &screen_responses});
    if (tiles) tiles->add_to(ports);
    return ports;
}

void Machine::run() {
    const SimulationContext::Scope scope(context);
    sc_core::sc_start();
    if (is_stuck || clock.is_stuck()) throw MachineStuck(stuck_report());
    waiting_quads = 0;
    while (scenes.size() > 1 && scenes.front().is_done())
        scenes.pop_front();
}

// The memory's own figures are those of the requests that it has served.
void Machine::settle() {
    for (Unit* unit : units())
        unit->settle();
    texel_caches.settle();
    queues->settle(clock.now());
    frame_statistics.cycles += clock.now() - frame_statistics.cycles.value();
}

void Machine::finish_frame(std::uint32_t number) {
    settle();
    memory->settle();
    FrameWaits waits;
    if (bottlenecks) waits = bottlenecks->end_frame();
    bottleneck_statistics.count(waits, frame_begin);
    if (series) series->end_frame(statistics(), number);
    frame.frame = number;
    frame.cycles = clock.now() - frame_begin;
    frame_begin = clock.now();
    frame.commands = ledger.end_frame(clock.now(), waits);
    for (const CommandCycles& command : frame.commands)
        shapes.add(command.shape);
    frame.waited.clear();
    if (on_retire) frame.waited = std::move(waits.runs);
    if (on_frame) on_frame(frame);
}

std::vector<Unit*> Machine::units() {
    std::vector<Unit*> all{&host,
                           &command_processor,
                           &vertex_fetch,
                           &geometry,
                           &clip,
                           &setup,
                           &raster,
                           &depth,
                           &texture,
                           &fragment,
                           &color,
                           &scan_out,
                           &arbiter};
    if (Unit* unit = texel_caches.unit()) all.insert(all.begin() + 9, unit); // behind texture
    if (interpolator) all.insert(all.begin() + 7, interpolator.get());       // behind raster
    if (tiles) {
        const std::vector<Unit*> more = tiles->units();
        all.insert(all.begin() + 6, more.begin(), more.end()); // behind set-up
    }
    if (Unit* unit = memory->unit()) all.push_back(unit);
    return all;
}

// In the order of the pipe, or shuffled by a linear congruential generator.
void Machine::attach_units(std::uint32_t seed) {
    auto shuffled = units();
    for (std::size_t i = shuffled.size() - 1; i > 0 && seed != 0; --i) {
        seed = seed * 1664525u + 1013904223u;
        std::swap(shuffled[i], shuffled[(seed >> 16) % (i + 1)]);
    }
    for (Unit* unit : shuffled)
        unit->attach();
}

bool Machine::must_wait() {
    if (clock.now() >= next_progress_check) check_progress();
    if (is_stuck || host.starves() || raster.starves()) return true;
    if (series && series->is_due()) {
        settle();
        series->record(statistics());
    }
    clock.ask_from(std::min(next_progress_check, series ? series->interval_end() : Never));
    return false;
}

void Machine::connect_memory(Unit& unit, RequestPort& requests, Channel<std::uint64_t>& responses) {
    const std::string& name = unit.account().unit();
    requests.channel().connect(name + "_requests", unit, arbiter);
    responses.connect(name + "_responses", arbiter, unit);
}

void Machine::retire(const QuadToken& token, Cycle now) {
    const Cycle cycles = now - std::max(last_retired, frame_begin);
    last_retired = now;
    if (observer) observer->retired(name_of(token), now);
    tell_end(token, cycles, now);
}

void Machine::tell_end(const QuadToken& token, Cycle cycles, Cycle now) {
    if (!on_retire) return;
    const PreparedQuad& quad = token.quad();
    on_retire({.x = quad.x,
               .y = quad.y,
               .written = quad.after_depth,
               .texture_misses = token.misses,
               .cycles = cycles,
               .end = now});
}

} // namespace ffgpu::timing
