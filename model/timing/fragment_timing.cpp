#include "model/timing/fragment_timing.h"

#include "model/timing/fragment_pipes.h"

#include <algorithm>

namespace ffgpu::timing {

// In the order in which they came: a quad whose pipe's queue is full holds up those behind it.
void FragmentTiming::distribute() {
    for (std::size_t i = 0; i < pipes_.size() && ports_.quads_in.can_pop(); ++i) {
        Pipe& pipe = pipes_[fragment_pipe(config_, ports_.quads_in.front().quad())];
        if (pipe.waiting.size() == config_.fragment.pipe_queue) return;
        pipe.waiting.push_back(ports_.quads_in.pop());
    }
}

Activity FragmentTiming::step(Pipe& pipe) {
    if (pipe.cycles_left > 0) {
        --pipe.cycles_left;
        return Activity::Busy;
    }
    if (pipe.waiting.empty()) return Activity::Idle;
    if (!ports_.quads_out.can_push()) return Activity::StalledOutput;
    const std::uint32_t cycles =
        pipe.waiting.front().draw().combiners * config_.fragment.combiner_cycles;
    pipe.cycles_left = std::max(cycles, 1u) - 1;
    ports_.quads_out.push(pipe.waiting.front());
    pipe.waiting.pop_front();
    return Activity::Busy;
}

// The pipes share the way out: a different one is first whenever one has worked.
Activity FragmentTiming::step() {
    distribute();
    bool worked = false, stalled = false;
    for (std::size_t i = 0; i < pipes_.size(); ++i) {
        const Activity activity = step(pipes_[(first_ + i) % pipes_.size()]);
        worked |= activity == Activity::Busy;
        stalled |= activity == Activity::StalledOutput;
    }
    if (worked) {
        first_ = (first_ + 1) % pipes_.size();
        return Activity::Busy;
    }
    return stalled ? Activity::StalledOutput : Activity::Idle;
}

bool FragmentTiming::may_sleep() const {
    return ports_.quads_in.holds_nothing() &&
           std::all_of(pipes_.begin(), pipes_.end(), [](const Pipe& pipe) {
               return pipe.cycles_left == 0 && pipe.waiting.empty();
           });
}

} // namespace ffgpu::timing
