#include "model/timing/scan_out.h"

#include <algorithm>

namespace ffgpu::timing {

// Stalls end with a response or a free place.
Cycle ScanOut::next_work(Activity last) const {
    if (config_.refresh_cycles == 0 || shown_.lines == 0) return Never;
    if (last == Activity::Busy) return now() + 1;
    return last == Activity::Idle ? std::max(now() + 1, due()) : Never;
}

Activity ScanOut::step() {
    while (ports_.responses_in.can_pop()) {
        ports_.responses_in.pop();
        --outstanding_;
    }
    if (config_.refresh_cycles == 0 || shown_.lines == 0) return Activity::Idle;
    if (surface_.lines == 0) begin_ = now();
    if (surface_.lines == 0 || (next_ == surface_.lines && now() >= due())) {
        if (surface_.lines != 0) {
            begin_ += config_.refresh_cycles;
            ++statistics_.refreshes;
        }
        surface_ = shown_;
        next_ = 0;
    }
    if (next_ == surface_.lines || now() < due()) return Activity::Idle;
    if (outstanding_ == config_.queue || !ports_.requests_out.can_push())
        return outstanding_ == config_.queue ? Activity::StalledMemory : Activity::StalledRequests;
    statistics_.late_lines += now() > due();
    ports_.requests_out.push({.address = surface_.address + next_ * config_.line_bytes,
                              .bytes = config_.line_bytes,
                              .write = false,
                              .client = Client::ScanOut});
    ++next_;
    ++outstanding_;
    return Activity::Busy;
}

} // namespace ffgpu::timing
