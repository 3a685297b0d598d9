// TimelineTrace: what the units of the machine in time do, cycle by cycle, as a timeline. It
// listens on the machine's thread and writes on one of its own; what waits between is bounded.

#pragma once

#include "model/timing/activity_observer.h"
#include "model/timing/memory_observer.h"
#include "model/timing/series.h"
#include "model/work/job_thread.h"
#include "tools/export/timeline_format.h"

#include <memory>
#include <string>
#include <vector>

namespace ffgpu::tools {

class TimelineTrace final : public timing::ActivityObserver,
                            public timing::MemoryObserver,
                            public timing::SeriesSink {
public:
    static constexpr std::uint64_t Interval = 1000; // cycles of a counter's value

    TimelineTrace(TimelineFormat& format, const std::vector<std::string>& units);

    void changed(std::size_t unit, timing::Activity activity, std::uint64_t first) override;
    void sent(const timing::MemoryRequest&, std::uint64_t) override {}
    void done(const timing::MemoryRequest& request, std::uint64_t cycle) override;
    // Of the queues' columns.
    void columns(std::span<const timing::SeriesColumn> columns) override;
    void sample(const timing::SeriesSample& sample) override;
    void end_frame(std::uint32_t) override {}
    void frame(const timing::FrameTiming& frame);

    // Throws what went wrong with writing.
    void check_failure() { writer_.check_failure(); }
    // The machine has stopped at `time`: returns when all is written.
    void finish(std::uint64_t time);

private:
    static constexpr std::size_t Chunk = std::size_t{1} << 14;
    struct Change {
        std::uint64_t time = 0;
        std::uint32_t unit = 0;
        timing::Activity activity = timing::Activity::Idle;
    };

    void write_changes();
    void begin_interval(std::uint64_t begin);
    void write_traffic();

    TimelineFormat& format_;
    std::vector<Change> changes_;
    TrafficInterval traffic_;
    std::vector<std::size_t> queue_columns_;
    work::JobThread writer_; // The last: its thread uses the others.
};

} // namespace ffgpu::tools
