// Series: what every account of the machine counted, interval after interval. Each frame begins an
// interval, and ends one, so that the samples of a frame sum to its figures.
//
// Who wants them is a SeriesSink: files, pages and exporters alike.

#pragma once

#include "model/base/statistics.h"
#include "model/timing/unit.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ffgpu::timing {

// As Counter has them.
struct SeriesColumn {
    std::string_view name, unit, meaning;
};

struct SeriesSample {
    Cycle begin = 0;                       // cycles of the machine before it
    Cycle cycles = 0;                      // that it covers
    std::span<const std::uint64_t> counts; // counted in them, a column each
};

// Called on the thread that runs the machine.
class SeriesSink {
public:
    virtual ~SeriesSink() = default;
    // Once, before the first sample. The names live as long as the machine.
    virtual void columns(std::span<const SeriesColumn> columns) = 0;
    virtual void sample(const SeriesSample& sample) = 0;
    // The samples since the last call were this frame's.
    virtual void end_frame(std::uint32_t frame) = 0;
};

// Has the clock walk through the last cycle of each interval; a unit that does nothing.
class SeriesRecorder final : public Unit {
public:
    SeriesRecorder(sc_core::sc_module_name name, const Clock& clock, Cycle interval)
        : Unit(name, clock)
        , interval_(interval)
        , next_(interval) {}

    // Null: nobody.
    void set_sink(SeriesSink* sink) { sink_ = sink; }

    Cycle interval_end() const { return next_; }
    // An interval ends with this cycle, unless the frame does.
    bool is_due() const { return now() == next_; }
    // All groups are brought up to date with this cycle. They are the same in every call.
    void record(const std::vector<const StatisticsGroup*>& groups);
    // At the end of a frame, in the same way: also where the interval is not over.
    void end_frame(const std::vector<const StatisticsGroup*>& groups, std::uint32_t frame);

private:
    Activity step() override { return Activity::Idle; }
    Cycle next_work(Activity) const override { return now() < next_ ? next_ : now() + 1; }
    void name_columns(const std::vector<const StatisticsGroup*>& groups);

    const Cycle interval_;
    Cycle next_; // the last cycle of the interval
    Cycle begin_ = 0;
    SeriesSink* sink_ = nullptr;
    std::vector<SeriesColumn> columns_;
    std::vector<std::uint64_t> before_, counts_;
};

} // namespace ffgpu::timing
