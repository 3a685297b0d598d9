#include "model/timing/gpu_timing.h"

#include "model/timing/cache_port.h"
#include "model/timing/color_timing.h"
#include "model/timing/command_processor.h"
#include "model/timing/depth_timing.h"
#include "model/timing/fragment_timing.h"
#include "model/timing/geometry_timing.h"
#include "model/timing/memory_arbiter.h"
#include "model/timing/memory_controller.h"
#include "model/timing/memory_lines.h"
#include "model/timing/raster_timing.h"
#include "model/timing/setup_timing.h"
#include "model/timing/simulation_context.h"
#include "model/timing/texture_timing.h"
#include "model/timing/vertex_fetch.h"
#include "model/work/machine_order.h"

#include <deque>
#include <utility>

// SystemC's library has a main() of its own that calls this; our programs have theirs.
__attribute__((visibility("default"))) int sc_main(int, char**) {
    return 0;
}

namespace ffgpu::timing {
namespace {

constexpr std::size_t MostWaiting = 1 << 14; // quads that are prepared before they are run

class FrameStatistics : public StatisticsGroup {
public:
    Counter& cycles = count("total_cycles", "cycles", "of the machine's clock");
    Counter& host_written_bytes =
        count("host_written_bytes", "bytes", "that the driver wrote to device memory");
    Counter& host_read_bytes =
        count("host_read_bytes", "bytes", "that the driver read from device memory");
};

CacheConfig vertex_cache(const VertexConfig& config) {
    CacheConfig cache;
    cache.sets = config.cache_sets;
    cache.ways = config.cache_ways;
    cache.line_bytes = config.line_bytes;
    return cache;
}

} // namespace

// The block diagram. Members are made in this order: clock, memory ports, links, units.
class GpuTiming::Machine final : public work::MachineSink {
public:
    Machine(const SimulationContext& kernel,
            const TimingConfig& wanted,
            std::uint32_t evaluation_order,
            const MakeMemory& make_memory)
        : context(kernel)
        , config(wanted)
        , order(config.work(), *this)
        , clock("clock", [this] { return must_wait(); })
        , in_flight(clock)
        , memory_in_flight(clock)
        , command_requests(clock, config.memory.client_queue, memory_in_flight)
        , command_responses(clock, ResponseQueue)
        , vertex_port(
              "vertex_cache", clock, vertex_cache(config.vertex), Client::Vertex, memory_in_flight)
        , texel_port(
              "texel_cache", clock, config.texel_cache.cache(), Client::Texture, memory_in_flight)
        , depth_port("depth_cache", clock, config.depth_cache, Client::Depth, memory_in_flight)
        , color_port("color_cache", clock, config.color_cache, Client::Color, memory_in_flight)
        , draws(clock, 4)
        , vertices(clock, config.vertex.fetch_queue)
        , primitives(clock, config.setup.queue, config.vertex.latency)
        , setups(clock, config.setup.queue)
        , raster_to_depth(clock, config.raster.queue)
        , depth_to_texture(clock, config.fragment.queue)
        , texture_to_fragment(clock, config.fragment.queue)
        , fragment_to_depth(
              clock, config.fragment.queue, config.fragment.latency, config.raster.quads_per_cycle)
        , depth_to_color(clock, config.fragment.queue)
        , command_processor("command_processor",
                            clock,
                            config,
                            {.draws_out = draws,
                             .requests_out = command_requests,
                             .responses_in = command_responses,
                             .depth_cache = depth_port.cache,
                             .color_cache = color_port.cache,
                             .ledger = ledger},
                            in_flight,
                            memory_in_flight)
        , vertex_fetch("vertex_fetch",
                       clock,
                       config.vertex,
                       {.draws_in = draws,
                        .vertices_out = vertices,
                        .responses_in = vertex_port.responses,
                        .cache = vertex_port.cache})
        , geometry("geometry",
                   clock,
                   config.vertex,
                   {.vertices_in = vertices, .primitives_out = primitives})
        , setup("setup", clock, config, {.primitives_in = primitives, .setups_out = setups})
        , raster("raster",
                 clock,
                 config.raster,
                 {.setups_in = setups, .quads_out = raster_to_depth},
                 in_flight)
        , depth("depth",
                clock,
                config,
                {.early_in = raster_to_depth,
                 .early_out = depth_to_texture,
                 .late_in = fragment_to_depth,
                 .late_out = depth_to_color,
                 .responses_in = depth_port.responses,
                 .cache = depth_port.cache},
                in_flight)
        , texture("texture",
                  clock,
                  config,
                  {.quads_in = depth_to_texture,
                   .quads_out = texture_to_fragment,
                   .responses_in = texel_port.responses,
                   .cache = texel_port.cache})
        , fragment("fragment",
                   clock,
                   config,
                   {.quads_in = texture_to_fragment, .quads_out = fragment_to_depth})
        , color("color",
                clock,
                config,
                {.quads_in = depth_to_color,
                 .responses_in = color_port.responses,
                 .cache = color_port.cache},
                in_flight,
                [this](const QuadToken& token, Cycle now) { retire(token, now); })
        , arbiter("arbiter",
                  clock,
                  config.memory,
                  {.requests_in = {&command_requests.channel(),
                                   &vertex_port.requests.channel(),
                                   &texel_port.requests.channel(),
                                   &depth_port.requests.channel(),
                                   &color_port.requests.channel()},
                   .responses_out = {&command_responses,
                                     &vertex_port.responses,
                                     &texel_port.responses,
                                     &depth_port.responses,
                                     &color_port.responses}},
                  memory_in_flight)
        , memory(make_memory ? make_memory(clock, config.memory)
                             : std::make_unique<MemoryController>("memory", clock, config.memory)) {
        draws.connect(command_processor, vertex_fetch);
        vertices.connect(vertex_fetch, geometry);
        primitives.connect(geometry, setup);
        setups.connect(setup, raster);
        raster_to_depth.connect(raster, depth);
        depth_to_texture.connect(depth, texture);
        texture_to_fragment.connect(texture, fragment);
        fragment_to_depth.connect(fragment, depth);
        depth_to_color.connect(depth, color);
        connect_memory(command_processor, command_requests, command_responses);
        connect_memory(vertex_fetch, vertex_port.requests, vertex_port.responses);
        connect_memory(texture, texel_port.requests, texel_port.responses);
        connect_memory(depth, depth_port.requests, depth_port.responses);
        connect_memory(color, color_port.requests, color_port.responses);
        memory->connect(arbiter);
        arbiter.socket.bind(memory->target());
        attach_units(evaluation_order);
    }

    // MachineSink
    void scene(work::PreparedScene&& scene) override {
        waiting_quads += scene.quads.size() + scene.draws.size();
        scenes.emplace_back(std::move(scene), ledger);
        scenes.back().host_writes = std::exchange(host_writes, {});
        command_processor.enqueue(scenes.back());
        if (waiting_quads > MostWaiting) run();
    }
    void transfer(work::PreparedTransfer&& transfer) override {
        command_processor.enqueue(std::move(transfer));
        if (++waiting_quads > MostWaiting) run();
    }
    void host_transfer(const HostTransfer& transfer) override {
        (transfer.is_write ? frame_statistics.host_written_bytes
                           : frame_statistics.host_read_bytes) += transfer.bytes;
        if (transfer.is_write) host_writes.push_back({transfer.at, transfer.at + transfer.bytes});
    }
    void end_frame(std::uint32_t number) override {
        command_processor.enqueue_frame_end();
        run();
        finish_frame(number);
    }

    // Runs until the command processor has nothing left to read. Time stands still then, so that
    // nobody can see in a result how often this is done.
    void run() {
        const SimulationContext::Scope scope(context);
        sc_core::sc_start();
        waiting_quads = 0;
        while (scenes.size() > 1 && scenes.front().is_done())
            scenes.pop_front();
    }

    void finish_frame(std::uint32_t number) {
        for (Unit* unit : units())
            unit->settle();
        memory->settle();
        frame_statistics.cycles += clock.now() - frame_statistics.cycles.value();
        frame.frame = number;
        frame.cycles = clock.now() - frame_begin;
        frame_begin = clock.now();
        frame.commands = ledger.end_frame(clock.now());
        if (on_frame) on_frame(frame);
    }

    std::vector<Unit*> units() {
        std::vector<Unit*> all{&command_processor,
                               &vertex_fetch,
                               &geometry,
                               &setup,
                               &raster,
                               &depth,
                               &texture,
                               &fragment,
                               &color,
                               &arbiter};
        if (Unit* unit = memory->unit()) all.push_back(unit);
        return all;
    }

    const SimulationContext& context;
    const TimingConfig config;
    work::MachineOrder order;
    Clock clock;
    InFlight in_flight, memory_in_flight;
    CommandLedger ledger;
    std::deque<TimedScene> scenes;
    std::size_t waiting_quads = 0; // and draws and transfers, since run()

    RequestPort command_requests;
    Channel<std::uint64_t> command_responses;
    CachePort vertex_port, texel_port, depth_port, color_port;

    Channel<DrawToken> draws;
    Channel<VertexToken> vertices;
    Channel<PrimitiveToken> primitives;
    Channel<SetupToken> setups;
    Channel<QuadToken> raster_to_depth, depth_to_texture, texture_to_fragment, fragment_to_depth,
        depth_to_color;

    CommandProcessor command_processor;
    VertexFetch vertex_fetch;
    GeometryTiming geometry;
    SetupTiming setup;
    RasterTiming raster;
    DepthTiming depth;
    TextureTiming texture;
    FragmentTiming fragment;
    ColorTiming color;
    MemoryArbiter arbiter;
    std::unique_ptr<MemoryModule> memory;

    std::vector<HostWrite> host_writes; // since the last scene
    FrameStatistics frame_statistics;
    FrameTiming frame;
    Cycle frame_begin = 0;
    Cycle last_retired = 0;
    Cycle next_progress_check = 0;
    Cycle busy_at_last_check = ~Cycle{0};
    std::function<void(const FrameTiming&)> on_frame;
    std::function<void(const QuadRetired&)> on_retire;

private:
    // In the order of the pipe, or shuffled by a linear congruential generator.
    void attach_units(std::uint32_t seed) {
        auto shuffled = units();
        for (std::size_t i = shuffled.size() - 1; i > 0 && seed != 0; --i) {
            seed = seed * 1664525u + 1013904223u;
            std::swap(shuffled[i], shuffled[(seed >> 16) % (i + 1)]);
        }
        for (Unit* unit : shuffled)
            unit->attach();
    }

    bool must_wait() {
        if (clock.now() >= next_progress_check) check_progress();
        return command_processor.starves();
    }

    // A machine in which no unit has worked for a million cycles is wired wrongly.
    void check_progress() {
        constexpr Cycle Interval = 1'000'000;
        Cycle busy = 0;
        for (Unit* unit : units())
            busy += unit->account().cycles(Activity::Busy);
        check(busy != busy_at_last_check || clock.now() == 0, "the timed machine is stuck");
        busy_at_last_check = busy;
        next_progress_check = clock.now() + Interval;
    }

    void connect_memory(Unit& unit, RequestPort& requests, Channel<std::uint64_t>& responses) {
        requests.channel().connect(unit, arbiter);
        responses.connect(arbiter, unit);
    }

    void retire(const QuadToken& token, Cycle now) {
        const Cycle cycles = now - std::max(last_retired, frame_begin);
        last_retired = now;
        if (!on_retire) return;
        const PreparedQuad& quad = token.quad();
        on_retire({.x = quad.x,
                   .y = quad.y,
                   .written = quad.after_depth,
                   .texture_misses = token.misses,
                   .cycles = cycles});
    }
};

GpuTiming::GpuTiming(const TimingConfig& config,
                     std::uint32_t evaluation_order,
                     const MakeMemory& make_memory)
    : context_(std::make_unique<SimulationContext>()) {
    check_memory_lines(config);
    const SimulationContext::Scope scope(*context_);
    machine_ = std::make_unique<Machine>(*context_, config, evaluation_order, make_memory);
}

GpuTiming::~GpuTiming() {
    const SimulationContext::Scope scope(*context_);
    machine_.reset();
}

void GpuTiming::command(std::shared_ptr<const work::WholeCommand> command) {
    machine_->order.command(std::move(command));
}

void GpuTiming::host_transfer(const HostTransfer& transfer) {
    machine_->order.host_transfer(transfer);
}

void GpuTiming::end_frame(std::uint32_t frame) {
    machine_->order.end_frame(frame);
}

void GpuTiming::catch_up() {
    machine_->run();
}

void GpuTiming::set_on_frame(std::function<void(const FrameTiming&)> on_frame) {
    machine_->on_frame = std::move(on_frame);
}

void GpuTiming::set_on_retire(std::function<void(const QuadRetired&)> on_retire) {
    machine_->on_retire = std::move(on_retire);
}

std::uint64_t GpuTiming::cycles() const {
    return machine_->clock.now();
}

std::vector<const StatisticsGroup*> GpuTiming::statistics() const {
    std::vector<const StatisticsGroup*> groups{&machine_->frame_statistics};
    for (Unit* unit : machine_->units())
        groups.push_back(&unit->account());
    groups.push_back(&machine_->vertex_fetch.statistics());
    groups.push_back(&machine_->texture.statistics());
    for (const CachePort* port : {&machine_->vertex_port,
                                  &machine_->texel_port,
                                  &machine_->depth_port,
                                  &machine_->color_port})
        groups.push_back(&port->cache.statistics());
    groups.push_back(&machine_->arbiter.statistics());
    for (const StatisticsGroup* group : machine_->memory->statistics())
        groups.push_back(group);
    return groups;
}

std::vector<std::string> GpuTiming::unit_names() const {
    std::vector<std::string> names;
    for (Unit* unit : machine_->units())
        names.push_back(unit->account().unit());
    return names;
}

} // namespace ffgpu::timing
