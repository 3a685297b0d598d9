#include "tools/export/timeline_trace.h"

#include <utility>

namespace ffgpu::tools {

TimelineTrace::TimelineTrace(TimelineFormat& format, const std::vector<std::string>& units)
    : format_(format)
    , writer_(8 * Chunk) {
    writer_.push(1, [this, units] { format_.begin(units); });
}

void TimelineTrace::changed(std::size_t unit, timing::Activity activity, std::uint64_t first) {
    changes_.push_back({first - 1, static_cast<std::uint32_t>(unit), activity});
    if (changes_.size() >= Chunk) write_changes();
}

void TimelineTrace::write_changes() {
    const std::size_t weight = 1 + changes_.size(); // An argument may move what another one asks.
    writer_.push(weight, [this, changes = std::exchange(changes_, {})] {
        for (const Change& change : changes)
            format_.change(change.unit, change.activity, change.time);
    });
}

// Bytes count when they are moved, as in the statistics.
void TimelineTrace::done(const timing::MemoryRequest& request, std::uint64_t cycle) {
    const std::uint64_t interval = cycle / Interval * Interval;
    if (interval > traffic_.begin) begin_interval(interval);
    traffic_.bytes[static_cast<std::size_t>(request.client)] += request.bytes;
}

// A counter keeps its value until the next: where nothing is moved it says so.
void TimelineTrace::begin_interval(std::uint64_t begin) {
    write_traffic();
    traffic_ = {traffic_.begin + Interval, {}};
    if (traffic_.begin < begin) write_traffic();
    traffic_.begin = begin;
}

void TimelineTrace::write_traffic() {
    writer_.push(1, [this, traffic = traffic_] { format_.traffic(traffic); });
}

void TimelineTrace::columns(std::span<const timing::SeriesColumn> columns) {
    constexpr std::string_view Begin = "queue_", End = "_item_cycles";
    std::vector<std::string> names;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        std::string_view name = columns[i].name;
        if (!name.starts_with(Begin) || !name.ends_with(End)) continue;
        name.remove_prefix(Begin.size());
        name.remove_suffix(End.size());
        names.emplace_back(name);
        queue_columns_.push_back(i);
    }
    writer_.push(1, [this, names] { format_.queues(names); });
}

void TimelineTrace::sample(const timing::SeriesSample& sample) {
    QueueInterval interval{sample.begin, {}};
    for (const std::size_t column : queue_columns_)
        interval.items.push_back(static_cast<double>(sample.counts[column]) /
                                 static_cast<double>(sample.cycles));
    writer_.push(1, [this, interval] { format_.queue_items(interval); });
}

void TimelineTrace::frame(const timing::FrameTiming& frame) {
    writer_.push(1 + frame.commands.size(), [this, frame] { format_.frame(frame); });
}

void TimelineTrace::finish(std::uint64_t time) {
    write_changes();
    write_traffic();
    writer_.push(1, [this, time] { format_.end(time); });
    writer_.drain();
}

} // namespace ffgpu::tools
