#include "model/timing/series.h"

#include <utility>

namespace ffgpu::timing {

void SeriesRecorder::name_columns(const std::vector<const StatisticsGroup*>& groups) {
    for (const StatisticsGroup* const group : groups)
        for (const Counter& counter : group->counters())
            columns_.push_back({counter.name(), counter.unit(), counter.meaning()});
    before_.resize(columns_.size());
    counts_.resize(columns_.size());
    if (sink_) sink_->columns(columns_);
}

void SeriesRecorder::record(const std::vector<const StatisticsGroup*>& groups) {
    if (columns_.empty()) name_columns(groups);
    std::size_t column = 0;
    for (const StatisticsGroup* const group : groups) {
        for (const Counter& counter : group->counters()) {
            counts_[column] = counter.value() - std::exchange(before_[column], counter.value());
            ++column;
        }
    }
    if (sink_) sink_->sample({.begin = begin_, .cycles = now() - begin_, .counts = counts_});
    begin_ = now();
    next_ = now() + interval_;
    wake(next_);
}

void SeriesRecorder::end_frame(const std::vector<const StatisticsGroup*>& groups,
                               std::uint32_t frame) {
    record(groups);
    if (sink_) sink_->end_frame(frame);
}

} // namespace ffgpu::timing
