#include "tools/report/frame_meter.h"

#include <exception>
#include <utility>

namespace ffgpu::tools {

FrameMeter::FrameMeter(StatisticsReport& report, timing::GpuTiming* timing)
    : report_(report)
    , timing_(timing) {
    if (!timing_) return;
    timing_->let_frames_overlap();
    timing_->set_on_frame([this](const timing::FrameTiming& frame) { ended_ = frame; });
}

FrameMeter::~FrameMeter() {
    try {
        if (timing_) timing_->catch_up();
    } catch (const std::exception&) {
        // Who wants to know has caught up before.
    }
}

void FrameMeter::add(const work::FrameFigures& frame, Added added) {
    if (timing_)
        return timing_->post([this, frame, added = std::move(added)] { add_timed(frame, added); });
    report_.add(frame, {});
    added(nullptr);
}

void FrameMeter::add_timed(const work::FrameFigures& frame, const Added& added) {
    const TimedFigures timed{.counters = changes_.take(timing_->statistics()),
                             .histograms = histogram_changes_.take(timing_->histograms()),
                             .frame = std::exchange(ended_, std::nullopt)};
    report_.add(frame, timed);
    added(timed.frame ? &*timed.frame : nullptr);
}

} // namespace ffgpu::tools
