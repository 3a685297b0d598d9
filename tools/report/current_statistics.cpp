#include "tools/report/current_statistics.h"

#include "tools/report/statistics_file.h"

#include <algorithm>
#include <utility>

namespace ffgpu::tools {
namespace {

using Clock = std::chrono::steady_clock;

constexpr Clock::duration Interval = std::chrono::seconds(1);
constexpr int Share = 50; // One part of the time in so many goes into writing.

} // namespace

CurrentStatistics::CurrentStatistics(const StatisticsReport& report,
                                     const PictureList& pictures,
                                     std::string folder)
    : report_(report)
    , pictures_(pictures)
    , folder_(std::move(folder)) {}

void CurrentStatistics::begin() const {
    if (!folder_.empty()) remove_statistics_files(folder_);
}

void CurrentStatistics::frame_ended() {
    const Clock::time_point begin = Clock::now();
    if (begin < next_) return;
    write();
    const Clock::time_point end = Clock::now();
    next_ = end + std::max(Interval, Share * (end - begin));
}

void CurrentStatistics::write() {
    if (folder_.empty()) return;
    // First: where there are statistics without it nobody knows whose the pictures are.
    pictures_.write(folder_);
    write_statistics_file(report_, folder_);
}

} // namespace ffgpu::tools
