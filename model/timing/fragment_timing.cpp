#include "model/timing/fragment_timing.h"

#include "model/timing/fragment_pipes.h"

#include <algorithm>

namespace ffgpu::timing {

bool FragmentTiming::can_distribute() const {
    if (!ports_.quads_in.can_pop()) return false;
    const Pipe& pipe = pipes_[fragment_pipe(config_, ports_.quads_in.front().quad())];
    return pipe.waiting.size() < config_.fragment.pipe_queue;
}

// In the order in which they came: a quad whose pipe's queue is full holds up those behind it.
void FragmentTiming::distribute() {
    for (std::size_t i = 0; i < pipes_.size() && can_distribute(); ++i) {
        Pipe& pipe = pipes_[fragment_pipe(config_, ports_.quads_in.front().quad())];
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

} // namespace ffgpu::timing
