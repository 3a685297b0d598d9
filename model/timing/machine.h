// Machine: the units of the machine in time, their links and their ports to memory. Members are
// made in the order of the block diagram: clock, memory ports, links, units; machine.cpp wires them
// by name.

#pragma once

#include "model/timing/bottleneck_search.h"
#include "model/timing/cache_port.h"
#include "model/timing/clip_timing.h"
#include "model/timing/color_timing.h"
#include "model/timing/command_processor.h"
#include "model/timing/depth_timing.h"
#include "model/timing/fragment_timing.h"
#include "model/timing/geometry_timing.h"
#include "model/timing/gpu_timing.h"
#include "model/timing/host_bus.h"
#include "model/timing/interpolator_timing.h"
#include "model/timing/memory_arbiter.h"
#include "model/timing/quad_observer.h"
#include "model/timing/queue_statistics.h"
#include "model/timing/raster_timing.h"
#include "model/timing/scan_out.h"
#include "model/timing/series.h"
#include "model/timing/setup_timing.h"
#include "model/timing/shape_statistics.h"
#include "model/timing/simulation_context.h"
#include "model/timing/stuck_report.h"
#include "model/timing/target_blocks.h"
#include "model/timing/texel_caches.h"
#include "model/timing/texture_timing.h"
#include "model/timing/tile_path.h"
#include "model/timing/vertex_fetch.h"
#include "model/work/machine_order.h"

#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace ffgpu::timing {

class FrameStatistics : public StatisticsGroup {
public:
    Counter& cycles = count("total_cycles", "cycles", "of the machine's clock");
};

class Machine final : public work::MachineSink {
public:
    // As GpuTiming's constructor has them.
    Machine(const SimulationContext& kernel,
            const TimingConfig& wanted,
            const Evaluation& evaluation,
            const MakeMemory& make_memory);

    // MachineSink
    void scene(work::PreparedScene&& scene) override;
    void part(work::PreparedPart&& part) override;
    bool takes_parts() const override { return true; }
    void transfer(work::PreparedTransfer&& transfer) override;
    void host_transfer(const HostTransfer& transfer) override;
    void end_commands() override;
    void end_frame(std::uint32_t number) override;
    void content(work::PreparedContent&& content) override;
    void host_access(std::vector<work::TransferLine>&& lines) override;
    void texels_rewritten(std::vector<std::uint64_t>&& lines) override;
    // What the screen reads from its next refresh on.
    void show(const work::PlacedLevel& picture);

    // Runs until the host's bus could have nothing left to send, or the rasterizer could come to
    // quads that were not told. Time stands still then, so that
    // nobody can see in a result how often this is done.
    void run();

    // As GpuTiming has it.
    void leave_out_figures();

    std::vector<Unit*> units();
    // All that are connected, in the order of the units that they lead to.
    std::vector<const Link*> links();
    std::vector<const StatisticsGroup*> statistics();
    std::vector<const Histogram*> histograms();

    const SimulationContext& context;
    const TimingConfig config;
    Clock clock;
    InFlight in_flight, memory_in_flight, screen_in_flight;
    CommandLedger ledger;
    std::deque<TimedScene> scenes;
    std::deque<TimedScene*> scenes_without_quads; // that wait for some
    bool commands_ended = false;                  // of the frame under way
    std::uint64_t scenes_told = 0;
    std::size_t waiting_quads = 0; // and draws and transfers, since run()

    RequestPort host_requests, command_requests, screen_requests;
    Channel<std::uint64_t> host_responses, command_responses, screen_responses;
    CachePort index_port, vertex_port, depth_port, color_port;
    TexelCaches texel_caches;
    TargetBlocks blocks;
    TexelRewrites rewrites;

    Channel<CommandToken> commands;
    Channel<Drained> drained;
    Channel<DrawToken> draws;
    Channel<VertexToken> vertices;
    Channel<PrimitiveToken> primitives, clipped;
    Channel<SetupToken> setups;
    Channel<BinToken> bins;                    // tile-based
    Channel<QuadToken> raster_to_interpolator, // where there is one
        raster_to_depth, depth_to_texture, texture_to_fragment, fragment_to_depth, depth_to_color;

    HostBus host;
    CommandProcessor command_processor;
    VertexFetch vertex_fetch;
    GeometryTiming geometry;
    ClipTiming clip;
    SetupTiming setup;
    std::unique_ptr<TilePath> tiles; // of a tile-based machine
    RasterTiming raster;
    std::unique_ptr<InterpolatorTiming> interpolator; // null: attributes take no time
    DepthTiming depth;
    TextureTiming texture;
    FragmentTiming fragment;
    ColorTiming color;
    ScanOut scan_out;
    MemoryArbiter arbiter;
    std::unique_ptr<MemoryModule> memory;
    std::unique_ptr<BottleneckSearch> bottlenecks; // null: nobody looks
    std::unique_ptr<QueueStatistics> queues;
    std::unique_ptr<SeriesRecorder> series; // null: nobody wants them

    std::vector<HostWrite> host_writes; // since the last scene
    FrameStatistics frame_statistics;
    BottleneckStatistics bottleneck_statistics{config.interpolator.is_on()};
    ShapeStatistics shapes;
    FrameTiming frame;
    Cycle frame_begin = 0;
    Cycle last_retired = 0;
    Cycle next_progress_check = 0;
    Cycle busy_at_last_check = ~Cycle{0};
    bool is_stuck = false;
    std::function<void(const FrameTiming&)> on_frame;
    std::function<void(const QuadRetired&)> on_retire;
    QuadObserver* observer = nullptr;

private:
    void attach_units(std::uint32_t seed);
    std::vector<Stage> stages();
    void add_vertex_steps(Stage& fetch, Stage& transform, Stage& set_up);
    void add_texture_steps(Stage& stage);
    void add_texel_steps(Stage& stage);
    void add_fragment_steps(Stage& stage);
    Stage interpolator_stage();
    Stage raster_stage();
    Stage second_level_stage();
    void look_for_bottlenecks(Pace pace);
    std::vector<LineCache*> caches();
    bool must_wait();
    void check_progress();
    StuckParts stuck_parts();
    std::string stuck_report();
    Channel<QuadToken>& whole_quads(); // as raster or interpolator send them on
    void connect_links();
    MemoryArbiter::Ports memory_ports();
    void connect_memory(Unit& unit, RequestPort& requests, Channel<std::uint64_t>& responses);
    void settle();
    void finish_frame(std::uint32_t number);
    void retire(const QuadToken& token, Cycle now);
    // Of a quad that has passed the texture unit, also one that no fragment is left of.
    void tell_end(const QuadToken& token, Cycle cycles, Cycle now);
};

} // namespace ffgpu::timing
