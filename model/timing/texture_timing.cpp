#include "model/timing/texture_timing.h"

#include <algorithm>

namespace ffgpu::timing {

TextureTiming::TextureTiming(sc_core::sc_module_name name,
                             const Clock& clock,
                             const TimingConfig& config,
                             const Ports& ports)
    : Unit(name, clock)
    , config_(config)
    , ports_(ports)
    , exit_(config, ports.quads_out)
    , pipes_(config.raster.quads_per_cycle, TexturePipe(config, ports.cache)) {}

bool TextureTiming::can_distribute() const {
    return ports_.quads_in.can_pop() &&
           pipes_[fragment_pipe(config_, ports_.quads_in.front())].can_take();
}

// In the order in which they came: a quad whose pipe's queue is full holds up those behind it.
void TextureTiming::distribute() {
    for (std::size_t i = 0; i < pipes_.size() && can_distribute(); ++i) {
        const std::uint32_t pipe = fragment_pipe(config_, ports_.quads_in.front());
        pipes_[pipe].take(ports_.quads_in.pop());
        exit_.enter(pipe);
    }
}

Activity TextureTiming::step() {
    ports_.cache.begin_cycle(ports_.responses_in);
    Activity reason = Activity::Idle;
    distribute();
    bool worked = false;
    // The pipes share the cache's ports and the way out: a different one is first whenever one
    // has worked.
    for (std::size_t i = 0; i < pipes_.size(); ++i) {
        const std::size_t pipe = (first_ + i) % pipes_.size();
        worked |= pipes_[pipe].filter(exit_, pipe, reason);
        worked |= pipes_[pipe].compare_tags(statistics_, reason);
    }
    worked |= exit_.advance();
    if (!worked) return reason;
    first_ = (first_ + 1) % pipes_.size();
    return Activity::Busy;
}

} // namespace ffgpu::timing
