// CurrentStatistics: keeps stats.json and pictures.csv as new as their frames, within a second or
// so, so that they are there where the process is killed. Writing takes a small share of the time,
// however many frames there are.

#pragma once

#include "tools/report/picture_list.h"
#include "tools/report/statistics_report.h"

#include <chrono>
#include <string>

namespace ffgpu::tools {

class CurrentStatistics {
public:
    // `folder` empty: none is written.
    CurrentStatistics(const StatisticsReport& report,
                      const PictureList& pictures,
                      std::string folder);

    // Pictures will be: files of an older run, which tell of others, go.
    void begin() const;
    // Throws InputError, as write().
    void frame_ended();
    void write();

private:
    const StatisticsReport& report_;
    const PictureList& pictures_;
    const std::string folder_;
    std::chrono::steady_clock::time_point next_{};
};

} // namespace ffgpu::tools
