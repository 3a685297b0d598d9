#include "model/timing/fragment_timing.h"

#include <algorithm>
#include <utility>

namespace ffgpu::timing {

bool FragmentTiming::can_distribute() const {
    if (!ports_.quads_in.can_pop()) return false;
    return has_place(pipes_[fragment_pipe(config_, ports_.quads_in.front())]);
}

bool FragmentTiming::is_empty() const {
    return exit_.is_empty() && std::all_of(pipes_.begin(), pipes_.end(), [](const Pipe& pipe) {
               return pipe.waiting.empty() && pipe.cycles_left == 0;
           });
}

// In the order in which they came: a quad whose pipe's queue is full holds up those behind it.
void FragmentTiming::distribute() {
    const std::size_t pipes = config_.raster.quads_per_cycle;
    for (std::size_t i = 0; i < pipes && ports_.quads_in.can_pop(); ++i) {
        const std::uint32_t number = fragment_pipe(config_, ports_.quads_in.front());
        Pipe& pipe = pipes_[number];
        if (!has_place(pipe)) return;
        pipe.waiting.push_back(ports_.quads_in.front());
        ports_.quads_in.drop();
        ++pipe.passage.entered;
        exit_.enter(number);
    }
}

[[gnu::always_inline]] inline void FragmentTiming::send(std::size_t number) {
    Pipe& pipe = pipes_[number];
    exit_.push(number, pipe.waiting.front());
    pipe.waiting.pop_front();
    pipe.passage.leave();
    ++pipe.passage.worked;
}

// A quad leaves at the end of its cycles.
inline Activity FragmentTiming::go_round(std::size_t number) {
    Pipe& pipe = pipes_[number];
    if (pipe.waiting.empty()) return Activity::Idle;
    if (!std::exchange(pipe.inside, true))
        pipe.cycles_left = config_.fragment.cycles(pipe.waiting.front().draw().combiners);
    if (pipe.cycles_left > 1) {
        --pipe.cycles_left;
        ++pipe.passage.worked;
        return Activity::Busy;
    }
    if (!exit_.can_push(number)) return Activity::StalledOutput;
    send(number);
    pipe.inside = false;
    return Activity::Busy;
}

Activity FragmentTiming::step(std::size_t number) {
    if (config_.fragment.entry_cycles > 0) return go_round(number);
    Pipe& pipe = pipes_[number];
    if (pipe.cycles_left > 0) {
        --pipe.cycles_left;
        ++pipe.passage.worked;
        return Activity::Busy;
    }
    if (pipe.waiting.empty()) return Activity::Idle;
    if (!exit_.can_push(number)) return Activity::StalledOutput;
    const std::uint32_t cycles = config_.fragment.cycles(pipe.waiting.front().draw().combiners);
    pipe.cycles_left = std::max(cycles, 1u) - 1;
    send(number);
    return Activity::Busy;
}

// The pipes share the way out: a different one is first whenever one has worked.
Activity FragmentTiming::step() {
    if (ports_.quads_in.can_pop()) distribute();
    const std::size_t pipes = config_.raster.quads_per_cycle;
    bool worked = false, stalled = false;
    for (std::size_t i = 0; i < pipes; ++i) {
        const Activity activity = step(turn(first_ + i, pipes));
        worked |= activity == Activity::Busy;
        stalled |= activity == Activity::StalledOutput;
    }
    worked |= exit_.advance();
    if (worked) {
        first_ = turn(first_ + 1, pipes);
        if (!ports_.quads_in.can_pop() && is_empty()) rest_as(Activity::Idle);
        return Activity::Busy;
    }
    return stalled ? Activity::StalledOutput : Activity::Idle;
}

} // namespace ffgpu::timing
