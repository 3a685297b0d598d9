// GpuTiming: the machine in time. It reads the work stream of the functional GPU and never changes
// a pixel. machine.cpp wires the units and reads as the block diagram.
//
// Each GpuTiming has a SystemC simulation context of its own, so several can exist in a process,
// one after the other or side by side. Commands are made ready on a thread of its own, and its
// machine runs on another, which also makes the calls of on_frame and on_retire; SystemC keeps the
// current context in a global, so of several machines one runs at a time.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/command_ledger.h"
#include "model/timing/config.h"
#include "model/timing/memory_module.h"
#include "model/timing/wait_paths.h"
#include "model/work/job_thread.h"
#include "model/work/machine_order.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ffgpu::timing {

// The end of a quad that the texture unit has let through, for maps of the screen: it retired, or
// the tests behind that unit left none of its fragments.
struct QuadRetired {
    std::uint16_t x = 0, y = 0; // window pixel of lane 0
    std::uint8_t written = 0;   // four bits
    std::uint32_t texture_misses = 0;
    std::uint64_t cycles = 0; // since the quad before it retired; 0 where it did not
    std::uint64_t end = 0;    // the last of them, since the machine's start
};

// What one frame took; counters are since the start (the reader subtracts).
struct FrameTiming {
    std::uint32_t frame = 0;
    std::uint64_t cycles = 0;
    std::vector<CommandCycles> commands; // all of them; the sum of theirs is `cycles`
    // What its cycles were waited for; empty where nobody is told of quads' ends, or nobody looked.
    std::vector<WaitPaths::Run> waited{};
};

class ActivityObserver;    // activity_observer.h
class DramCommandObserver; // memory/dram_commands.h
class Histogram;           // histogram.h
class Machine;
class MachineThread;
class MemoryObserver; // memory_observer.h
class QuadObserver;   // quad_observer.h
class SeriesSink;     // series.h
class SimulationContext;

class GpuTiming final : public work::CommandSink {
public:
    // `evaluation`: for the tests that prove it invisible.
    // `make_memory`: a memory of one's own behind the TLM-2.0 socket; none: MemoryController.
    // Throws InputError for a configuration whose parts do not fit together.
    explicit GpuTiming(const TimingConfig& config,
                       const Evaluation& evaluation = {},
                       const MakeMemory& make_memory = {});
    ~GpuTiming() override;

    void command(std::shared_ptr<const work::WholeCommand> command) override;
    void content(const std::shared_ptr<const SurfaceContent>& content) override;
    void host_transfer(const HostTransfer& transfer) override;
    // Runs the machine until the frame's last quad is written, then calls on_frame.
    void end_frame(std::uint32_t frame) override;
    // Kinds of misses, how full queues were, whether the memory's buses were busy and what with,
    // and who waited how long for it are not counted: for who listens and reads no figures. No
    // cycle depends on it. Before the first command.
    void leave_out_figures();
    // From now on end_frame() returns before that: the next frame is made ready while this one
    // runs, and what went wrong in it may come out of a later one's. For who listens, or reads
    // figures, on the machine's thread; who reads them elsewhere calls catch_up() before.
    void let_frames_overlap();
    // Calls `job` on the machine's thread, when the machine has gone as far as the commands so far
    // allow: there it may read figures. What it throws ends the machine, as its own failures do.
    void post(std::function<void()> job);
    // Runs the machine as far as the commands so far allow, which is otherwise put off while they
    // are few. No figure of a whole frame depends on it.
    void catch_up();

    void set_on_frame(std::function<void(const FrameTiming&)> on_frame);
    void set_on_retire(std::function<void(const QuadRetired&)> on_retire);
    // Told on the thread that runs the machine; null: nobody.
    void set_quad_observer(QuadObserver* observer);
    void set_memory_observer(MemoryObserver* observer);       // the same
    void set_command_observer(DramCommandObserver* observer); // of our DRAM; the same
    void set_activity_observer(ActivityObserver* observer); // of units in the order of their names

    // What every account counts, over time (series.h), where series.interval_cycles says so; null:
    // nobody. Before the first command.
    void set_series_sink(SeriesSink* sink);

    // Of each pixel of a colour surface that is drawn on, or of the depths that go with it, row by
    // row: bytes of memory that its block takes, none where the block's state says all. After a
    // frame's end. Empty where no states are kept, or nothing was drawn.
    std::vector<std::uint32_t> block_bytes(const Surface& color, bool depth);

    std::uint64_t cycles() const;
    // All units' groups: accounts, caches, memory. They add up at the end of a frame.
    std::vector<const StatisticsGroup*> statistics() const;
    // Of frames that have ended.
    std::vector<const Histogram*> histograms() const;
    // The units' names in the order of the pipe; each has NAME_busy_cycles and so on.
    std::vector<std::string> unit_names() const;

private:
    void tell_parts(const work::JobThread& preparation);

    std::unique_ptr<SimulationContext> context_;
    std::unique_ptr<Machine> machine_;
    std::unique_ptr<MachineThread> thread_;     // uses the machine
    std::unique_ptr<work::MachineOrder> order_; // uses the thread
    bool contents_told_ = false;
    bool frames_overlap_ = false;
    std::unique_ptr<work::JobThread> preparation_; // uses order_
};

} // namespace ffgpu::timing
