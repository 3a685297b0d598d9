#include "tools/report/frame_meter.h"

#include <utility>

namespace ffgpu::tools {

FrameMeter::FrameMeter(StatisticsReport& report, timing::GpuTiming* timing)
    : report_(report)
    , timing_(timing) {
    if (timing_)
        timing_->set_on_frame([this](const timing::FrameTiming& frame) { ended_ = frame; });
}

std::optional<timing::FrameTiming> FrameMeter::add(const work::FrameFigures& frame) {
    TimedFigures timed;
    if (timing_) {
        timing_->catch_up();
        timed.counters = changes_.take(timing_->statistics());
        timed.histograms = histogram_changes_.take(timing_->histograms());
        timed.frame = std::exchange(ended_, std::nullopt);
    }
    report_.add(frame, timed);
    return std::move(timed.frame);
}

} // namespace ffgpu::tools
