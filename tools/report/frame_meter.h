// FrameMeter: adds frames to the report, with what the machine in time took for each.

#pragma once

#include "model/timing/gpu_timing.h"
#include "model/work/frame_figures.h"
#include "tools/report/counter_changes.h"
#include "tools/report/statistics_report.h"

#include <optional>

namespace ffgpu::tools {

class FrameMeter {
public:
    // `timing` may be null: the report has none then. It listens to the ends of frames.
    FrameMeter(StatisticsReport& report, timing::GpuTiming* timing);

    // The frame's work is all handed over. Returns what the machine took, if there is one.
    std::optional<timing::FrameTiming> add(const work::FrameFigures& frame);

private:
    StatisticsReport& report_;
    timing::GpuTiming* const timing_;
    CounterChanges changes_;
    HistogramChanges histogram_changes_;
    std::optional<timing::FrameTiming> ended_; // since the last add()
};

} // namespace ffgpu::tools
