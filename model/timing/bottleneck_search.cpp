#include "model/timing/bottleneck_search.h"

#include <string>
#include <utility>

namespace ffgpu::timing {

BottleneckStatistics::BottleneckStatistics(bool interpolates) {
    const auto is_there = [&](std::size_t i) {
        return interpolates || static_cast<Resource>(i) != Resource::Interpolator;
    };
    for (std::size_t i = 0; i < Resources; ++i)
        if (is_there(i))
            waited_[i] = &add("bottleneck_" + std::string(ResourceNames[i]) + "_cycles",
                              "cycles",
                              "in which the machine waited for it");
    for (std::size_t i = 0; i < Resources; ++i)
        if (is_there(i))
            gained_[i] = &add("gain_" + std::string(ResourceNames[i]) + "_cycles",
                              "cycles",
                              "that its frames would take less without its limits");
}

void BottleneckStatistics::count(const FrameWaits& waits, Cycle begin) {
    for (const WaitPaths::Run& run : waits.runs)
        *waited_[static_cast<std::size_t>(run.resource)] += run.end - std::exchange(begin, run.end);
    for (std::size_t i = 0; i < Resources; ++i)
        if (const float saved = waits.saved[static_cast<Resource>(i)]; gained_[i] && saved > 0)
            *gained_[i] += static_cast<Cycle>(saved);
}

BottleneckSearch::BottleneckSearch(const Clock& clock, PipeParts parts, bool beside)
    : clock_(clock)
    , parts_(std::move(parts))
    , watch_(clock, parts_)
    , bottlenecks_(parts_)
    , thread_(beside ? std::make_unique<work::JobThread>(Waiting) : nullptr) {
    watch_.write_to(logs_[written_]);
}

void BottleneckSearch::end_cycle(std::size_t charged) {
    watch_.end_cycle(charged);
    if (watch_.is_full() || !thread_) hand_over();
}

// A job is begun when the one before it is done: where two wait at the most, that of the log to be
// written next was done before.
void BottleneckSearch::hand_over() {
    watch_.finish_log();
    PipeLog& log = logs_[written_];
    written_ = (written_ + 1) % logs_.size();
    const auto reckon = [this, &log] {
        bottlenecks_.reckon(log);
        log.clear();
    };
    if (thread_)
        thread_->push(1, reckon);
    else
        reckon();
    watch_.write_to(logs_[written_]);
}

FrameWaits BottleneckSearch::end_frame() {
    hand_over();
    if (thread_) thread_->drain();
    return bottlenecks_.end_frame(clock_.now());
}

} // namespace ffgpu::timing
