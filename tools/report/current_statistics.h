// CurrentStatistics: keeps stats.json as new as its frames, within a second or so, so that it is
// there where the process is killed. Writing takes a small share of the time, however many frames
// there are.

#pragma once

#include "tools/report/statistics_report.h"

#include <chrono>
#include <string>

namespace ffgpu::tools {

class CurrentStatistics {
public:
    // `folder` empty: none is written.
    CurrentStatistics(const StatisticsReport& report, std::string folder);

    // Pictures will be: a file of an older run, which tells of others, goes.
    void begin() const;
    // Throws InputError, as write().
    void frame_ended();
    void write();

private:
    const StatisticsReport& report_;
    const std::string folder_;
    std::chrono::steady_clock::time_point next_{};
};

} // namespace ffgpu::tools
