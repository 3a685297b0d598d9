// FrameMeter: adds frames to the report, with what the machine in time took for each.
//
// The machine is behind who hands it frames: a frame is added on the machine's thread when it has
// ended there, while the next ones are drawn and made ready.

#pragma once

#include "model/timing/gpu_timing.h"
#include "model/work/frame_figures.h"
#include "tools/report/counter_changes.h"
#include "tools/report/statistics_report.h"

#include <functional>
#include <optional>

namespace ffgpu::tools {

class FrameMeter {
public:
    // Told what the machine took; null: there is no machine, or no frame ended in it.
    using Added = std::function<void(const timing::FrameTiming*)>;

    // `timing` may be null: the report has none then. It listens to the ends of frames, which
    // overlap from now on.
    FrameMeter(StatisticsReport& report, timing::GpuTiming* timing);
    ~FrameMeter(); // Waits for the machine.
    FrameMeter(const FrameMeter&) = delete;
    FrameMeter& operator=(const FrameMeter&) = delete;

    // The frame's work is all handed over. Calls `added` behind its being added; with a machine on
    // its thread, at the latest before its catch_up() returns, out of which comes what is thrown.
    void add(const work::FrameFigures& frame, Added added);

private:
    void add_timed(const work::FrameFigures& frame, const Added& added);

    StatisticsReport& report_;
    timing::GpuTiming* const timing_;
    // The machine's thread's:
    CounterChanges changes_;
    HistogramChanges histogram_changes_;
    std::optional<timing::FrameTiming> ended_; // since the last was added
};

} // namespace ffgpu::tools
