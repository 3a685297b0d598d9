// ExplainedTiming: the machine in time beside a collector of histories: it notes for the watched
// fragments which of their texels' lines were in the cache, and when their quads were done.

#pragma once

#include "model/timing/gpu_timing.h"
#include "model/timing/quad_observer.h"
#include "model/work/command_assembler.h"
#include "model/work/machine_order.h"
#include "tools/explain/history_collector.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace ffgpu::tools {

class ExplainedTiming final : private work::CommandSink, private timing::QuadObserver {
public:
    ExplainedTiming(const timing::TimingConfig& config, const HistoryCollector& collector);

    // Reads the functional GPU's work.
    WorkSink& sink() { return assembler_; }

    std::uint64_t cycles() const { return timing_.cycles(); }

private:
    using Notes = std::vector<std::shared_ptr<FragmentNote>>;

    // The order that is followed beside the machine's own, for its addresses, has no machine.
    struct NoMachine final : work::MachineSink {
        void scene(work::PreparedScene&&) override {}
        void transfer(work::PreparedTransfer&&) override {}
        void host_transfer(const HostTransfer&) override {}
        void end_frame(std::uint32_t) override {}
    };

    void command(std::shared_ptr<const work::WholeCommand> command) override;
    void content(const std::shared_ptr<const SurfaceContent>& content) override;
    void host_transfer(const HostTransfer& transfer) override;
    void end_frame(std::uint32_t frame) override;

    void texel_line(const timing::QuadName& quad, const timing::CacheLine& line) override;
    void depth_line(const timing::QuadName& quad, const timing::CacheLine& line) override;
    void color_line(const timing::QuadName& quad, const timing::CacheLine& line) override;
    void retired(const timing::QuadName& quad, std::uint64_t cycle) override;

    void note_lines(FragmentNote& note);
    void note_target(const timing::QuadName& quad, const TargetLookup& lookup);

    const timing::TimingConfig config_;
    const HistoryCollector& collector_;
    NoMachine no_machine_;
    work::MachineOrder order_;
    work::CommandAssembler assembler_;
    std::mutex mutex_; // The machine may run on a thread of its own.
    std::map<timing::QuadName, Notes> quads_;
    timing::GpuTiming timing_; // The last: it tells the others.
};

} // namespace ffgpu::tools
