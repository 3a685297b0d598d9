// SeriesFile: the machine's accounts over time as series.csv: a row an interval, a column a
// counter. docs/stats.md names the columns. What frames leave waits in a file of its own.

#pragma once

#include "model/timing/gpu_timing.h"
#include "model/timing/series.h"
#include "tools/report/text_spool.h"

#include <string>

namespace ffgpu::tools {

class SeriesFile final : public timing::SeriesSink {
public:
    // Listens to the machine, if its configuration wants a series.
    explicit SeriesFile(timing::GpuTiming& timing) { timing.set_series_sink(this); }

    void columns(std::span<const timing::SeriesColumn> columns) override;
    void sample(const timing::SeriesSample& sample) override;
    void end_frame(std::uint32_t frame) override;

    // Of the frames that have ended. Throws InputError.
    void write(const std::string& folder) const;

private:
    std::string head_;
    std::vector<std::string> rows_; // of the frame under way, without its number
    TextSpool frames_;
};

} // namespace ffgpu::tools
