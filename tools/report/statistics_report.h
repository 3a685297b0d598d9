// StatisticsReport: stats.json. Equal for equal input and configuration, byte for byte: it holds no
// time, no thread count, no path. docs/stats.md is its schema. What frames leave waits in a file:
// memory does not grow with their number.

#pragma once

#include "model/timing/gpu_timing.h"
#include "model/work/frame_figures.h"
#include "tools/config/configuration.h"
#include "tools/report/counter_changes.h"
#include "tools/report/text_spool.h"

#include <memory>
#include <optional>
#include <string>

namespace ffgpu::tools {

// What the machine in time took for a frame.
struct TimedFigures {
    work::Figures counters;
    HistogramCounts histograms;
    std::optional<timing::FrameTiming> frame; // Nothing: no frame ended in it.
};

class StatisticsReport {
public:
    StatisticsReport(const Configuration& configuration, bool with_timing);
    ~StatisticsReport();

    // `timed` counts with timing only.
    void add(const work::FrameFigures& frame, const TimedFigures& timed);

    // The whole file so far; all but the frames, and the end, is the first piece.
    void write(const TextSink& out) const;

    bool has_frames() const;

    // A few lines for people.
    std::string summary() const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

} // namespace ffgpu::tools
